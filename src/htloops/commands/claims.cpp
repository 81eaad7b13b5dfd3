// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/claims.h"

#include "app/solve/boundaries.h"
#include "app/words.h"
#include "app/write/pair_listing.h"
#include "app/write/tables.h"

#include <boost/pending/disjoint_sets.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace htloops {
namespace {

std::string name_of_loop(std::size_t i) {
  return "pair " + std::to_string(i / 2) + (i % 2 == 0 ? ", handle" : ", tunnel");
}

std::string given_as(const std::string& what, const std::string& given, const std::string& is) {
  return what + " is given as " + given + ", but is " + is;
}

// Of what has faces.
struct Surface_counts
{
  std::size_t components = 0, boundaries = 0, genus = 0;
};

Surface_counts counts_of(const Mesh& mesh) {
  boost::disjoint_sets_with_storage<> joined(mesh.number_of_vertices());
  for(const Mesh::Edge_index e : mesh.edges())
    joined.union_set(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
  Surface_counts counts;
  std::size_t number_of_vertices = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v)) {
      ++number_of_vertices;
      counts.components += joined.find_set(v.idx()) == v.idx() ? 1 : 0;
    }
  counts.boundaries = find_boundaries(mesh, false).curves.size();
  // V - E + F = 2 C - 2 G - B
  counts.genus = (2 * counts.components + mesh.number_of_edges() - counts.boundaries -
                  number_of_vertices - mesh.number_of_faces()) /
                 2;
  return counts;
}

void compare(std::vector<std::string>& problems,
             const char* what,
             const std::optional<std::size_t>& given,
             std::size_t is) {
  if(given && *given != is)
    problems.push_back(given_as(what, std::to_string(*given), std::to_string(is)));
}

class Loop_comparison
{
public:
  Loop_comparison(const Loops_record& record, const Certificate& certificate)
      : record_(record)
      , linking_(certificate.linking) {}

  std::vector<std::string> problems() {
    for(std::size_t i = 0; i < linking_.size(); ++i) {
      const Loop_record& loop =
          record_.pairs[i / 2].loop(i % 2 == 0 ? Loop_type::HANDLE : Loop_type::TUNNEL);
      compare_side(i, "bounds", loop.bounds, word_for_side(linking_[i]));
      compare_side(i, "bounds_alone", loop.bounds_alone, word_for_side_alone(linking_[i]));
    }
    if(record_.linking && !linking_.empty())
      compare_linking();
    return std::move(problems_);
  }

private:
  using Entries = std::map<std::pair<long long, long long>, long long>;

  void compare_side(std::size_t i,
                    const char* key,
                    const std::optional<std::string>& given,
                    const std::string& is) {
    if(given && *given != is)
      problems_.push_back(name_of_loop(i) + ": " + given_as(key, *given, is));
  }

  // Numbers of loops of which nothing is known mean nothing.
  bool means_something(long long i) const {
    return i < 0 || i >= static_cast<long long>(linking_.size()) ||
           linking_[static_cast<std::size_t>(i)].problem.empty();
  }

  Entries computed_entries() const {
    Entries entries;
    for(std::size_t i = 0; i < linking_.size(); ++i)
      for(const auto& [j, value] : linking_[i].row)
        entries[{static_cast<long long>(i), static_cast<long long>(j)}] = value;
    return entries;
  }

  // Says the first that differs, and of how many there are.
  void compare_linking() {
    Entries differences = computed_entries();
    const Entries computed = differences;
    for(const auto& [i, j, value] : *record_.linking)
      differences[{i, j}] -= value;
    std::size_t number = 0;
    std::string first;
    for(const auto& [place, difference] : differences) {
      const auto [i, j] = place;
      if(difference == 0 || !means_something(i) || !means_something(j))
        continue;
      const auto is = computed.find(place);
      const long long value = is == computed.end() ? 0 : is->second;
      if(number++ == 0)
        first = given_as("linking [" + std::to_string(i) + ", " + std::to_string(j) + "]",
                         std::to_string(value - difference), std::to_string(value));
    }
    if(number != 0)
      problems_.push_back(
          first +
          (number == 1 ? "" : "; " + std::to_string(number) + " linking numbers are wrong"));
  }

  const Loops_record& record_;
  const std::vector<Loop_linking>& linking_;
  std::vector<std::string> problems_;
};

bool are_about_equal(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
}

} // namespace

std::vector<std::string> false_claims_on_surface(const Loops_record& record, const Mesh& mesh) {
  const Surface_counts counts = counts_of(mesh);
  std::vector<std::string> problems;
  compare(problems, "the number of components", record.number_of_components, counts.components);
  compare(problems, "the number of boundary curves", record.number_of_boundaries,
          counts.boundaries);
  compare(problems, "the genus", record.genus, counts.genus);
  return problems;
}

std::vector<std::string> false_claims_on_loops(const Loops_record& record,
                                               const Mesh& mesh,
                                               const Pairs& loops,
                                               const Certificate& certificate) {
  std::vector<std::string> problems = Loop_comparison(record, certificate).problems();
  const CGAL::Bbox_3 box = box_of(mesh);
  for(std::size_t k = 0; k < record.pairs.size(); ++k) {
    const double size = size_of(loops[k], box);
    if(record.pairs[k].size && !are_about_equal(*record.pairs[k].size, size))
      problems.push_back("pair " + std::to_string(k) + ": " +
                         given_as("the size", in_words(*record.pairs[k].size), in_words(size)));
  }
  return problems;
}

} // namespace htloops
