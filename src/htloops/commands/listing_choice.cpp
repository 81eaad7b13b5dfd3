// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/listing_choice.h"

#include "commands/box_option.h"
#include "commands/length_option.h"

#include <CLI/CLI.hpp>

#include <map>

namespace htloops {
namespace {

const std::map<std::string, Pair_order> orders = {{"size", Pair_order::SIZE},
                                                  {"length", Pair_order::LENGTH},
                                                  {"pair", Pair_order::PAIR},
                                                  {"place", Pair_order::PLACE}};

} // namespace

void add_listing_options(CLI::App& command, Listing_choice& choice, const std::string& group) {
  command
      .add_option("--sort", choice.order,
                  "size (of the shorter loop), length (of both), pair (the number) or place;\n"
                  "default: size, the smallest first")
      ->option_text("KEY")
      ->check(CLI::IsMember(orders))
      ->group(group);
  command
      .add_option("--shorter-than", choice.shorter_than,
                  "pairs with a loop that is shorter; %: of the diagonal of the box")
      ->option_text("L|P%")
      ->group(group);
  command.add_option("--longer-than", choice.longer_than, "pairs both loops of which are longer")
      ->option_text("L|P%")
      ->group(group);
  add_box_option(command, choice.box, "pairs")->group(group);
}

void check_listing_choice(const Listing_choice& choice) {
  if(!choice.shorter_than.empty())
    parse_length("--shorter-than", choice.shorter_than);
  if(!choice.longer_than.empty())
    parse_length("--longer-than", choice.longer_than);
  box_of(choice.box);
}

Listing_options listing_options(const Listing_choice& choice, const Mesh& mesh) {
  Listing_options options;
  options.order = orders.at(choice.order);
  if(!choice.shorter_than.empty())
    options.shorter_than = length_on(mesh, parse_length("--shorter-than", choice.shorter_than));
  if(!choice.longer_than.empty())
    options.longer_than = length_on(mesh, parse_length("--longer-than", choice.longer_than));
  options.box = box_of(choice.box);
  return options;
}

} // namespace htloops
