// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include "words.h"

#include <CGAL/Bbox_3.h>

#include <map>
#include <numeric>
#include <sstream>
#include <unordered_map>
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
      , is_turned_(number_of_faces, false)
      , is_one_sided_(number_of_faces, false) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  // puts two faces into one piece, which agree as they are or if one of them is turned. If they are
  // of one piece already and it says otherwise, that is not orientable.
  void join(std::uint32_t f, std::uint32_t g, bool must_turn) {
    Position a = find(f), b = find(g);
    const bool is_turned = (a.is_turned != b.is_turned) != must_turn;
    if(a.root == b.root) {
      is_one_sided_[a.root] = is_one_sided_[a.root] || is_turned;
      return;
    }
    if(sizes_[a.root] < sizes_[b.root])
      std::swap(a, b);
    parents_[b.root] = a.root;
    is_turned_[b.root] = is_turned;
    sizes_[a.root] += sizes_[b.root];
    is_one_sided_[a.root] = is_one_sided_[a.root] || is_one_sided_[b.root];
  }

  bool is_one_sided(std::uint32_t f) { return is_one_sided_[find(f).root]; }

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
  std::vector<bool> is_one_sided_;   // of roots: whether the piece is not orientable
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
// Faces of pieces that are not orientable are left out.
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
      if(pieces.is_one_sided(f))
        continue;
      const bool runs_up = (soup.source(h) == edge.vertices[0]) != is_turned[f];
      const std::uint32_t tip = soup.source(next_in_triangle(next_in_triangle(h)));
      wings_.push_back(
          {h, runs_up, pieces.piece(f), pieces.size_of_piece(f), exact_point(soup.points[tip])});
    }
    sort_around_edge();
  }

  std::size_t size() const { return wings_.size(); }

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

// The pieces that are not orientable, numbered among all pieces by their smallest vertices.
class One_sided_pieces
{
public:
  One_sided_pieces(const Mended_soup& mended, Face_pieces& pieces)
      : mended_(mended) {
    std::unordered_map<std::uint32_t, std::uint32_t> smallest_vertex;
    for(std::uint32_t f = 0; f < mended.soup.faces.size(); ++f) {
      const auto& face = mended.soup.faces[f];
      const std::uint32_t smallest = *std::min_element(face.begin(), face.end());
      const auto [known, is_new] = smallest_vertex.try_emplace(pieces.piece(f), smallest);
      known->second = (std::min)(known->second, smallest);
      if(pieces.is_one_sided(f))
        faces_[pieces.piece(f)].push_back(f);
    }
    for(const auto& [piece, smallest] : smallest_vertex)
      order_.push_back({smallest, piece});
    std::sort(order_.begin(), order_.end());
  }

  bool are_none() const { return faces_.empty(); }
  bool are_all() const { return faces_.size() == order_.size(); }

  // Names the first of them; there can be as many as faces.
  void report(Change_log& log) const {
    std::size_t number_told = 0, number_of_further_faces = 0;
    for(std::size_t i = 0; i < order_.size(); ++i) {
      const auto piece = faces_.find(order_[i].second);
      if(piece == faces_.end())
        continue;
      if(number_told++ < largest_number_told)
        log.add(Change_kind::ONE_SIDED_COMPONENT_DROPPED, piece->second.size(),
                words(i, piece->second));
      else
        number_of_further_faces += piece->second.size();
    }
    if(number_of_further_faces != 0)
      log.add(Change_kind::ONE_SIDED_COMPONENT_DROPPED, number_of_further_faces,
              "faces dropped in " +
                  counted(number_told - largest_number_told, "more component that is",
                          "more components that are") +
                  " not orientable");
  }

private:
  using Faces = std::vector<std::uint32_t>;

  static constexpr std::size_t largest_number_told = 8;

  std::string words(std::size_t number, const Faces& faces) const {
    return "of " + counted(mended_.soup.faces.size(), "face", "faces") + " dropped: component " +
           std::to_string(number) + " of " + std::to_string(order_.size()) +
           " is not orientable, first: " + name_of_face(mended_.face_in_file[faces.front()]) +
           ", bounding box: " + box_of(faces);
  }

  std::string box_of(const Faces& faces) const {
    CGAL::Bbox_3 box;
    for(const std::uint32_t f : faces)
      for(const std::uint32_t v : mended_.soup.faces[f])
        box += mended_.soup.points[v].bbox();
    std::ostringstream text;
    text << box.xmin() << ',' << box.ymin() << ',' << box.zmin() << ',' << box.xmax() << ','
         << box.ymax() << ',' << box.zmax();
    return text.str();
  }

  const Mended_soup& mended_;
  std::unordered_map<std::uint32_t, Faces> faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order_; // smallest vertices and pieces
};

// A turned face has its halfedges in the opposite order.
std::uint32_t turned(std::uint32_t h) { return h - h % 3 + (2 - h % 3); }

class Gluer
{
public:
  explicit Gluer(Mended_soup& mended)
      : mended_(mended) {}

  std::optional<Gluing> run(bool do_drop_one_sided) {
    glue_at_sound_edges();
    const One_sided_pieces one_sided(mended_, pieces_);
    if(!one_sided.are_none() && (!do_drop_one_sided || one_sided.are_all()))
      return std::nullopt;
    glue_at_crowded_edges();
    turn_faces();
    if(!one_sided.are_none()) {
      one_sided.report(mended_.log);
      drop_one_sided_pieces();
    }
    return std::move(gluing_);
  }

private:
  void glue(std::uint32_t h, std::uint32_t g) {
    pieces_.join(h / 3, g / 3, soup_.source(h) == soup_.source(g));
    gluing_.neighbors[h] = g;
    gluing_.neighbors[g] = h;
  }

  void glue_at_sound_edges() {
    edges_.for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() == 2)
        glue(edge.halfedge(0), edge.halfedge(1));
    });
  }

  // By the pieces that there are without these edges, and their sides. What is glued agrees, seen
  // turned: so no piece becomes one that is not orientable.
  void glue_at_crowded_edges() {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<bool> is_turned; // found out if it is needed
    edges_.for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() <= 2)
        return;
      if(is_turned.empty())
        is_turned = pieces_.turned_faces();
      Edge_star star(soup_, edge, pieces_, is_turned);
      const auto found = star.pairs();
      pairs.insert(pairs.end(), found.begin(), found.end());
      if(star.size() > 2)
        gluing_.crowded_edges.push_back(
            {{edge.vertices[0], edge.vertices[1]}, static_cast<std::uint32_t>(star.size())});
    });
    for(const auto& [h, g] : pairs)
      glue(h, g);
  }

  void turn_faces() {
    gluing_.is_turned = pieces_.turned_faces();
    const auto place = [&](std::uint32_t h) { return gluing_.is_turned[h / 3] ? turned(h) : h; };
    Neighbors neighbors(gluing_.neighbors.size(), no_halfedge);
    for(std::uint32_t h = 0; h < neighbors.size(); ++h)
      if(gluing_.neighbors[h] != no_halfedge)
        neighbors[place(h)] = place(gluing_.neighbors[h]);
    gluing_.neighbors = std::move(neighbors);
    turn(mended_.soup, gluing_.is_turned);
  }

  void drop_one_sided_pieces() {
    std::vector<bool> is_dropped(soup_.faces.size());
    for(std::uint32_t f = 0; f < soup_.faces.size(); ++f)
      is_dropped[f] = pieces_.is_one_sided(f);
    drop_faces(mended_, gluing_, is_dropped);
  }

  Mended_soup& mended_;
  Soup& soup_ = mended_.soup;
  const Edge_table edges_{soup_};
  Face_pieces pieces_{soup_.faces.size()};
  Gluing gluing_{Neighbors(3 * soup_.faces.size(), no_halfedge), {}, {}};
};

} // namespace

std::optional<Gluing> glue_faces(Mended_soup& mended, bool do_drop_one_sided) {
  return Gluer(mended).run(do_drop_one_sided);
}

void turn(Soup& soup, const std::vector<bool>& is_turned) {
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    if(is_turned[f])
      std::swap(soup.faces[f][1], soup.faces[f][2]);
}

void drop_faces(Mended_soup& mended, Gluing& gluing, const std::vector<bool>& is_dropped) {
  const std::size_t number_before = mended.soup.faces.size();
  std::vector<std::uint32_t> number(number_before);
  std::uint32_t kept = 0;
  for(std::size_t f = 0; f < number_before; ++f)
    if(!is_dropped[f]) {
      mended.soup.faces[kept] = mended.soup.faces[f];
      mended.face_in_file[kept] = mended.face_in_file[f];
      gluing.is_turned[kept] = gluing.is_turned[f];
      number[f] = kept++;
    }
  for(std::size_t h = 0; h < 3 * number_before; ++h)
    if(!is_dropped[h / 3]) {
      const std::uint32_t g = gluing.neighbors[h];
      gluing.neighbors[3 * number[h / 3] + h % 3] =
          g == no_halfedge ? no_halfedge : 3 * number[g / 3] + g % 3;
    }
  mended.soup.faces.resize(kept);
  mended.face_in_file.resize(kept);
  gluing.is_turned.resize(kept);
  gluing.neighbors.resize(3 * std::size_t(kept));
}

void drop_pillows(Mended_soup& mended, Gluing& gluing) {
  const Neighbors& neighbors = gluing.neighbors;
  std::vector<bool> is_dropped(mended.soup.faces.size(), false);
  bool has_any = false;
  for(std::uint32_t h = 0; h < neighbors.size(); h += 3) {
    const auto face_beyond = [&](std::uint32_t halfedge) {
      return neighbors[halfedge] == no_halfedge ? h / 3 : neighbors[halfedge] / 3;
    };
    const std::uint32_t g = face_beyond(h);
    is_dropped[h / 3] = g != h / 3 && face_beyond(h + 1) == g && face_beyond(h + 2) == g;
    if(is_dropped[h / 3])
      mended.log.add_face(Change_kind::PILLOW_FACES_DROPPED, mended.face_in_file[h / 3]);
    has_any = has_any || is_dropped[h / 3];
  }
  if(has_any)
    drop_faces(mended, gluing, is_dropped);
}

} // namespace htloops
