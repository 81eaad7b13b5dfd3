// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LINKING_WORDS_H
#define HTLOOPS_LINKING_WORDS_H

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>

#include <string>
#include <vector>

namespace htloops {

/// the word for the side on which a loop bounds: inside, outside, neither or undecided.
const char* word_for_side(const CGAL::Handle_tunnel_loops::Loop_linking& linking);

/// the same if the other components were not there.
const char* word_for_side_alone(const CGAL::Handle_tunnel_loops::Loop_linking& linking);

/// how many loops bound where; empty if linking numbers were not computed.
std::string summary_of_sides(const CGAL::Handle_tunnel_loops::Certificate& certificate);

/// a line for each loop that bounds on neither side or may do so, with the numbers that show it.
std::vector<std::string>
remarks_on_sides(const CGAL::Handle_tunnel_loops::Certificate& certificate);

} // namespace htloops

#endif // HTLOOPS_LINKING_WORDS_H
