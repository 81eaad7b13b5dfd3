// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LISTING_CHOICE_H
#define HTLOOPS_LISTING_CHOICE_H

#include "write/pair_listing.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace htloops {

/// The options that say which pairs are shown, drawn and listed, and in which order.
struct Listing_choice
{
  std::string order = "size";
  std::string shorter_than;
  std::string longer_than;
  std::vector<double> box;
};

void add_listing_options(CLI::App& command, Listing_choice& choice, const std::string& group);

/// throws `Failure` if an option makes no sense.
void check_listing_choice(const Listing_choice& choice);

/// what was chosen, with percentages of the diagonal of a mesh.
Listing_options listing_options(const Listing_choice& choice, const Mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_LISTING_CHOICE_H
