// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <map>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

// Pieces of faces that have been joined, and which faces of a piece have to be turned for all to
// agree. Disjoint sets, with a parity for each face.
class Face_pieces
{
public:
  explicit Face_pieces(std::size_t number_of_faces)
      : parents_(number_of_faces)
      , sizes_(number_of_faces, 1)
      , is_turned_(number_of_faces, false) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  // puts two faces into one piece, which agree as they are or if one of them is turned. False if
  // they are of one piece already and it says otherwise; then nothing is changed.
  bool join(std::uint32_t f, std::uint32_t g, bool must_turn) {
    Position a = find(f), b = find(g);
    const bool is_turned = (a.is_turned != b.is_turned) != must_turn;
    if(a.root == b.root)
      return !is_turned;
    if(sizes_[a.root] < sizes_[b.root])
      std::swap(a, b);
    parents_[b.root] = a.root;
    is_turned_[b.root] = is_turned;
    sizes_[a.root] += sizes_[b.root];
    return true;
  }

  // a face that stands for the piece, always the same until the next call of `join()`.
  std::uint32_t piece(std::uint32_t f) { return find(f).root; }
  std::size_t size_of_piece(std::uint32_t f) { return sizes_[find(f).root]; }

  // for each face whether it has to be turned: the fewer of each piece; if they are as many as the
  // others, not the first.
  std::vector<bool> turned_faces() {
    const auto number_of_faces = static_cast<std::uint32_t>(parents_.size());
    std::vector<std::uint32_t> number_turned(number_of_faces, 0);
    std::vector<bool> is_seen(number_of_faces, false), is_first_turned(number_of_faces, false);
    for(std::uint32_t f = 0; f < number_of_faces; ++f) {
      const Position at = find(f);
      number_turned[at.root] += at.is_turned ? 1 : 0;
      if(!is_seen[at.root])
        is_first_turned[at.root] = at.is_turned;
      is_seen[at.root] = true;
    }
    std::vector<bool> is_turned(number_of_faces);
    for(std::uint32_t f = 0; f < number_of_faces; ++f) {
      const Position at = find(f);
      const std::size_t others = sizes_[at.root] - number_turned[at.root];
      const bool are_most_turned = number_turned[at.root] > others ||
                                   (number_turned[at.root] == others && is_first_turned[at.root]);
      is_turned[f] = at.is_turned != are_most_turned;
    }
    return is_turned;
  }

private:
  struct Position
  {
    std::uint32_t root;
    bool is_turned; // against the root
  };

  // Halves the way to the root as it goes.
  Position find(std::uint32_t f) {
    bool is_turned = false;
    while(parents_[f] != f) {
      const std::uint32_t parent = parents_[f];
      if(parents_[parent] != parent) {
        is_turned_[f] = is_turned_[f] != is_turned_[parent];
        parents_[f] = parents_[parent];
      }
      is_turned = is_turned != is_turned_[f];
      f = parents_[f];
    }
    return {f, is_turned};
  }

  std::vector<std::uint32_t> parents_;
  std::vector<std::uint32_t> sizes_; // of roots
  std::vector<bool> is_turned_;      // against the parent
};

constexpr std::uint32_t no_partner = static_cast<std::uint32_t>(-1);

// A face at the edge.
struct Wing
{
  std::uint32_t halfedge;
  bool runs_up; // from the smaller vertex to the larger, after turning
  std::uint32_t piece;
  std::size_t size_of_piece;
  Exact_point tip;
  int sector = 0; // counted around the edge, from the first wing
};

// Which faces at an edge with more than two are neighbors: pairs of halfedges, as they are in the
// soup. The rest stays without neighbor.
//
// Going around the edge, one that runs downwards and one that runs upwards after it are a pair,
// between which there is solid: solids that meet at the edge come apart. Faces of one piece are
// paired first, the largest piece before the others, so that a surface goes on where a fin stands
// on it. `is_turned` tells which faces are to be seen turned. Decided exactly.
class Edge_star
{
public:
  Edge_star(const Soup& soup,
            const Edge_table::Edge& edge,
            Face_pieces& pieces,
            const std::vector<bool>& is_turned)
      : bottom_(exact_point(soup.points[edge.vertices[0]]))
      , top_(exact_point(soup.points[edge.vertices[1]])) {
    for(std::size_t i = 0; i < edge.size(); ++i) {
      const std::uint32_t h = edge.halfedge(i), f = h / 3;
      const bool runs_up = (soup.source(h) == edge.vertices[0]) != is_turned[f];
      const std::uint32_t tip = soup.source(next_in_triangle(next_in_triangle(h)));
      wings_.push_back(
          {h, runs_up, pieces.piece(f), pieces.size_of_piece(f), exact_point(soup.points[tip])});
    }
    sort_around_edge();
  }

  std::vector<std::array<std::uint32_t, 2>> pairs() {
    partner_.assign(wings_.size(), no_partner);
    for(const auto& size_and_group : groups_of_pieces())
      match(size_and_group.second);
    std::vector<std::uint32_t> rest;
    for(std::uint32_t i = 0; i < wings_.size(); ++i)
      if(partner_[i] == no_partner)
        rest.push_back(i);
    match(rest);
    std::vector<std::array<std::uint32_t, 2>> result;
    for(std::uint32_t i = 0; i < wings_.size(); ++i)
      if(partner_[i] != no_partner && i < partner_[i])
        result.push_back({wings_[i].halfedge, wings_[partner_[i]].halfedge});
    return result;
  }

private:
  // By the sizes of the pieces, which are negative here, and by their numbers.
  using Groups = std::map<std::pair<long long, std::uint32_t>, std::vector<std::uint32_t>>;

  bool is_flat(const Wing& wing) const { return CGAL::collinear(bottom_, top_, wing.tip); }

  // 0: beside the first wing, 1: less than half a turn from it, 2: opposite, 3: more, 4: nowhere,
  // as the face has no area.
  int sector_of(const Wing& wing, const Wing& first) const {
    if(is_flat(wing))
      return 4;
    switch(CGAL::orientation(bottom_, top_, first.tip, wing.tip)) {
    case CGAL::POSITIVE:
      return 1;
    case CGAL::NEGATIVE:
      return 3;
    default:
      return CGAL::coplanar_orientation(bottom_, top_, first.tip, wing.tip) == CGAL::POSITIVE ? 0
                                                                                              : 2;
    }
  }

  bool comes_before(const Wing& a, const Wing& b) const {
    if(a.sector != b.sector)
      return a.sector < b.sector;
    if(a.sector == 1 || a.sector == 3) {
      const CGAL::Orientation turn = CGAL::orientation(bottom_, top_, a.tip, b.tip);
      if(turn != CGAL::COPLANAR)
        return turn == CGAL::POSITIVE;
    }
    return a.halfedge < b.halfedge;
  }

  void sort_around_edge() {
    const auto first = std::find_if(wings_.begin(), wings_.end(),
                                    [this](const Wing& wing) { return !is_flat(wing); });
    if(first == wings_.end())
      return; // in the order of the file
    const Wing reference = *first;
    for(Wing& wing : wings_)
      wing.sector = sector_of(wing, reference);
    std::sort(wings_.begin(), wings_.end(),
              [this](const Wing& a, const Wing& b) { return comes_before(a, b); });
  }

  // Positions of wings around the edge: those of the largest piece, of the next one, ...
  Groups groups_of_pieces() const {
    Groups groups;
    for(std::uint32_t i = 0; i < wings_.size(); ++i) {
      const Wing& wing = wings_[i];
      groups[{-static_cast<long long>(wing.size_of_piece), wing.piece}].push_back(i);
    }
    return groups;
  }

  // Like brackets, on a circle: so twice around.
  void match(const std::vector<std::uint32_t>& group) {
    std::vector<std::uint32_t> open;
    for(int round = 0; round < 2; ++round)
      for(const std::uint32_t i : group) {
        if(partner_[i] != no_partner)
          continue;
        if(!wings_[i].runs_up) {
          if(round == 0)
            open.push_back(i);
        } else if(!open.empty()) {
          partner_[i] = open.back();
          partner_[open.back()] = i;
          open.pop_back();
        }
      }
  }

  const Exact_point bottom_, top_;
  std::vector<Wing> wings_;
  std::vector<std::uint32_t> partner_;
};

class Gluer
{
public:
  explicit Gluer(Mended_soup& mended)
      : mended_(mended) {}

  std::optional<Neighbors> run() {
    if(!glue_at_sound_edges() || !glue_at_crowded_edges())
      return std::nullopt;
    turn_faces();
    return std::move(neighbors_);
  }

private:
  // False where a face and its neighbor are of one piece and can never agree.
  bool glue(std::uint32_t h, std::uint32_t g) {
    if(!pieces_.join(h / 3, g / 3, soup_.source(h) == soup_.source(g)))
      return false;
    neighbors_[h] = g;
    neighbors_[g] = h;
    return true;
  }

  bool glue_at_sound_edges() {
    bool is_orientable = true;
    edges_.for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() == 2)
        is_orientable = glue(edge.halfedge(0), edge.halfedge(1)) && is_orientable;
    });
    return is_orientable;
  }

  // By the pieces that there are without these edges, and their sides.
  bool glue_at_crowded_edges() {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<bool> is_turned; // found out if it is needed
    Finding counter;
    edges_.for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() <= 2)
        return;
      if(is_turned.empty())
        is_turned = pieces_.turned_faces();
      const auto found = Edge_star(soup_, edge, pieces_, is_turned).pairs();
      pairs.insert(pairs.end(), found.begin(), found.end());
      counter.add([&] { return edge.name_with_faces(); });
    });
    bool is_orientable = true;
    for(const auto& [h, g] : pairs)
      is_orientable = glue(h, g) && is_orientable;
    if(!is_orientable)
      return false;
    report(mended_, counter, "edge with more than two faces split",
           "edges with more than two faces split");
    return true;
  }

  // A turned face has its halfedges in the opposite order.
  static std::uint32_t turned(std::uint32_t h) { return h - h % 3 + (2 - h % 3); }

  void turn_faces() {
    const std::vector<bool> is_turned = pieces_.turned_faces();
    Finding counter;
    const auto place = [&](std::uint32_t h) { return is_turned[h / 3] ? turned(h) : h; };
    Neighbors neighbors(neighbors_.size(), no_halfedge);
    for(std::uint32_t h = 0; h < neighbors_.size(); ++h)
      if(neighbors_[h] != no_halfedge)
        neighbors[place(h)] = place(neighbors_[h]);
    neighbors_ = std::move(neighbors);
    for(std::uint32_t f = 0; f < soup_.faces.size(); ++f)
      if(is_turned[f]) {
        std::swap(soup_.faces[f][1], soup_.faces[f][2]);
        counter.add([&] { return name_of_face(mended_.face_in_file[f]); });
      }
    report(mended_, counter, "face turned over", "faces turned over");
  }

  Mended_soup& mended_;
  Soup& soup_ = mended_.soup;
  const Edge_table edges_{soup_};
  Face_pieces pieces_{soup_.faces.size()};
  Neighbors neighbors_ = Neighbors(3 * soup_.faces.size(), no_halfedge);
};

} // namespace

std::optional<Neighbors> glue_faces(Mended_soup& mended) { return Gluer(mended).run(); }

} // namespace htloops
