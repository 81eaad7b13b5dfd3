// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/linking_words.h"

#include "words.h"

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Certificate;
using CGAL::Handle_tunnel_loops::Loop_linking;

std::string name_of_loop(std::size_t loop) {
  return "pair " + std::to_string(loop / 2) + (loop % 2 == 0 ? ", handle" : ", tunnel");
}

// "2 with pair 0, handle; -1 with itself"
std::string words(const std::vector<Loop_linking::Number>& numbers, std::size_t loop) {
  constexpr std::size_t largest_number_of_numbers = 4;
  std::string text;
  for(std::size_t i = 0; i < numbers.size() && i < largest_number_of_numbers; ++i)
    text += (text.empty() ? "" : "; ") + std::to_string(numbers[i].second) + " with " +
            (numbers[i].first == loop ? "itself" : name_of_loop(numbers[i].first));
  return text + (numbers.size() > largest_number_of_numbers ? "; ..." : "");
}

} // namespace

const char* word_for_side(const Loop_linking& linking) {
  return !linking.problem.empty()   ? "undecided"
         : linking.bounds_inside()  ? "inside"
         : linking.bounds_outside() ? "outside"
                                    : "neither";
}

const char* word_for_side_alone(const Loop_linking& linking) {
  return !linking.problem.empty()           ? "undecided"
         : linking.bounds_inside_component  ? "inside"
         : linking.bounds_outside_component ? "outside"
                                            : "neither";
}

std::string summary_of_sides(const Certificate& certificate) {
  const std::size_t pairs = certificate.linking.size() / 2;
  if(pairs == 0)
    return "";
  const std::size_t handles = *certificate.handles_bound_inside,
                    tunnels = *certificate.tunnels_bound_outside,
                    handles_alone = certificate.handles_bound_inside_alone.value_or(handles),
                    tunnels_alone = certificate.tunnels_bound_outside_alone.value_or(tunnels);
  return std::to_string(handles) + " of " +
         counted(pairs, "handle loop bounds", "handle loops bound") + " inside, " +
         std::to_string(tunnels) + " of " + counted(pairs, "tunnel loop", "tunnel loops") +
         " outside" +
         (handles_alone == handles && tunnels_alone == tunnels
              ? ""
              : "; each component by itself " + std::to_string(handles_alone) + " and " +
                    std::to_string(tunnels_alone));
}

std::vector<std::string> remarks_on_sides(const Certificate& certificate) {
  std::vector<std::string> lines;
  for(std::size_t i = 0; i < certificate.linking.size(); ++i) {
    const Loop_linking& linking = certificate.linking[i];
    if(!linking.problem.empty())
      lines.push_back(name_of_loop(i) + ": undecided, " + linking.problem);
    else if(!linking.bounds_inside() && !linking.bounds_outside())
      lines.push_back(
          name_of_loop(i) +
          ": bounds on neither side, by its linking numbers with loops pushed outwards (" +
          words(linking.row, i) + ") and of loops with it pushed outwards (" +
          words(linking.column, i) + ")");
  }
  return lines;
}

} // namespace htloops
