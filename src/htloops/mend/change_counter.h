// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANGE_COUNTER_H
#define HTLOOPS_CHANGE_COUNTER_H

#include "mend/mended_soup.h"

#include <string>

namespace htloops {

/// Counts changes of one kind and remembers the first.
class Change_counter
{
public:
  template <typename Name_of_element>
  void add(Name_of_element name_of_element, std::size_t count = 1) {
    if(count_ == 0 && count != 0)
      example_ = name_of_element();
    count_ += count;
  }

  std::size_t count() const { return count_; }

  /// `one` and `many` are what happened to one element or to several.
  void report(Mended_soup& mended, const std::string& one, const std::string& many) const {
    if(count_ != 0)
      mended.changes.push_back(
          {count_, (count_ == 1 ? one + ": " : many + ", the first is ") + example_});
  }

private:
  std::size_t count_ = 0;
  std::string example_;
};

} // namespace htloops

#endif // HTLOOPS_CHANGE_COUNTER_H
