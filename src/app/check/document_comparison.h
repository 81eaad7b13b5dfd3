// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DOCUMENT_COMPARISON_H
#define HTLOOPS_DOCUMENT_COMPARISON_H

#include "write/documents.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace htloops {

/// why a key of documents of loops or skeletons is not compared; empty if it is, null if there is
/// no such key.
const char* why_not_compared(const std::string& key);

/// What a document says that is not so, in words, in its order; and the keys that were not
/// compared, by the reason.
struct Document_differences
{
  std::vector<std::string> claims;
  std::map<std::string, std::set<std::string>> not_compared;
};

/// compares a document with that of the same answer as it is. Numbers are the same up to rounding:
/// lengths on a mesh with coordinates of at most \p largest_coordinate. What the document does not
/// say is no difference; nor are linking numbers, which have no order.
Document_differences
compare_documents(const Json& given, const Json& is, double largest_coordinate);

/// what is said, and is something else.
std::string given_as(const std::string& what, const std::string& given, const std::string& is);

} // namespace htloops

#endif // HTLOOPS_DOCUMENT_COMPARISON_H
