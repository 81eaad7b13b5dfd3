// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/face_gluing.h"

#include "mend/change_counter.h"
#include "mend/face_pieces.h"
#include "mend/faces_around_edge.h"
#include "read/edge_table.h"
#include "read/soup_words.h"

#include <utility>

namespace htloops {
namespace {

class Gluer
{
public:
  explicit Gluer(Mended_soup& mended)
      : mended_(mended)
      , soup_(mended.soup)
      , edges_(mended.soup)
      , pieces_(mended.soup.faces.size())
      , neighbors_(3 * mended.soup.faces.size(), no_halfedge) {}

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
    Change_counter counter;
    edges_.for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() <= 2)
        return;
      if(is_turned.empty())
        is_turned = pieces_.turned_faces();
      const auto found = pairs_around_edge(soup_, edge, pieces_, is_turned);
      pairs.insert(pairs.end(), found.begin(), found.end());
      counter.add([&] {
        return "edge " + std::to_string(edge.vertices[0]) + "-" + std::to_string(edge.vertices[1]) +
               " with " + std::to_string(edge.size()) + " faces";
      });
    });
    bool is_orientable = true;
    for(const auto& [h, g] : pairs)
      is_orientable = glue(h, g) && is_orientable;
    if(!is_orientable)
      return false;
    counter.report(mended_, "edge with more than two faces split",
                   "edges with more than two faces split");
    return true;
  }

  // A turned face has its halfedges in the opposite order.
  static std::uint32_t turned(std::uint32_t h) { return h - h % 3 + (2 - h % 3); }

  void turn_faces() {
    const std::vector<bool> is_turned = pieces_.turned_faces();
    Change_counter counter;
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
    counter.report(mended_, "face turned over", "faces turned over");
  }

  Mended_soup& mended_;
  Soup& soup_;
  const Edge_table edges_;
  Face_pieces pieces_;
  Neighbors neighbors_;
};

} // namespace

std::optional<Neighbors> glue_faces(Mended_soup& mended) { return Gluer(mended).run(); }

} // namespace htloops
