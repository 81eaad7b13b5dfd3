// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ZIP_ARCHIVE_H
#define HTLOOPS_ZIP_ARCHIVE_H

#include <cstdint>
#include <string>
#include <string_view>

namespace htloops {

/// Files in one, deflated, as ZIP has them: each behind a header, and a list of them at the end. It
/// is the same at any time: dates are that of its first day.
class Zip_archive
{
public:
  /// Throws `Failure` if the archive would be larger than ZIP without its extensions: four
  /// gigabytes.
  void add(const std::string& name, std::string_view content);

  std::string finish() &&;

private:
  std::string bytes_, list_;
  std::uint16_t number_of_files_ = 0;
};

} // namespace htloops

#endif // HTLOOPS_ZIP_ARCHIVE_H
