// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_HTML_PAGE_H
#define HTLOOPS_HTML_PAGE_H

#include "write/text_writer.h"

#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// A page that needs nothing but itself: no style, script or picture from elsewhere. Texts are
/// given as they are to be read.
class Html_page
{
public:
  Html_page(const std::string& target, std::string_view title);

  void paragraph(std::string_view text);

  /// the content of a PNG file with its caption; an empty one is left out.
  void picture(const std::string& png, std::string_view caption);

  /// The first row is the header; in columns from `first_number` to `last_number`, not included,
  /// there are numbers.
  void table(const std::vector<std::vector<std::string>>& rows,
             std::size_t first_number,
             std::size_t last_number);

  void finish();

private:
  Text_writer out_;
};

/// a text with what has a meaning in HTML replaced.
std::string html_of(std::string_view text);

std::string base64_of(std::string_view bytes);

} // namespace htloops

#endif // HTLOOPS_HTML_PAGE_H
