// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GRAPHML_WRITER_H
#define HTLOOPS_GRAPHML_WRITER_H

#include "write/files.h"

#include <cstddef>
#include <initializer_list>

namespace htloops {

/// Writes an undirected graph as GraphML: nodes, then edges, each with data of declared names.
class Graphml_writer
{
public:
  struct Key
  {
    const char* name;
    const char* target; ///< node or edge
    const char* type;
  };

  Graphml_writer(Text_writer& out, std::initializer_list<Key> keys)
      : out_(out) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
    for(const Key& key : keys)
      out_ << "<key id=\"" << key.name << "\" for=\"" << key.target << "\" attr.name=\"" << key.name
           << "\" attr.type=\"" << key.type << "\"/>\n";
    out_ << "<graph edgedefault=\"undirected\">\n";
  }

  void begin_node(std::size_t number) { out_ << "<node id=\"n" << number << "\">"; }
  void end_node() { out_ << "</node>\n"; }

  void begin_edge(std::size_t from, std::size_t to) {
    out_ << "<edge source=\"n" << from << "\" target=\"n" << to << "\">";
  }
  void end_edge() { out_ << "</edge>\n"; }

  /// of the node or edge that has begun.
  template <typename Value> void data(const char* name, const Value& value) {
    out_ << "<data key=\"" << name << "\">" << value << "</data>";
  }

  void finish() { out_ << "</graph>\n</graphml>\n"; }

private:
  Text_writer& out_;
};

} // namespace htloops

#endif // HTLOOPS_GRAPHML_WRITER_H
