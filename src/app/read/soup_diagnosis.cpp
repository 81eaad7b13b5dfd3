// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup_diagnosis.h"

#include "words.h"

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

namespace htloops {
namespace {

// calls visit(smaller vertex, larger vertex, halfedge).
template <typename Visit> void for_each_halfedge(const Soup& soup, Visit visit) {
  std::uint32_t halfedge = 0;
  for(const Soup_face& face : soup.faces)
    for(int i = 0; i < 3; ++i, ++halfedge) {
      const auto [near_vertex, far_vertex] = std::minmax({face[i], face[(i + 1) % 3]});
      visit(near_vertex, far_vertex, halfedge);
    }
}

// Of numbers of 32 bits: half the memory, which is what the time goes to.
using Number_map = boost::typed_identity_property_map<std::uint32_t>;
using Disjoint_sets = boost::disjoint_sets_with_storage<Number_map, Number_map>;

class Diagnostician
{
public:
  explicit Diagnostician(const Soup& soup)
      : soup_(soup) {}

  std::vector<Defect> run() {
    check_size();
    check_points();
    check_faces();
    // Without triangles there are no edges to speak of.
    if(are_faces_sound_) {
      edges_.emplace(soup_);
      check_edges();
      check_vertices();
    }
    return std::move(defects_);
  }

private:
  void report(const Finding& finding,
              Mesh_defect kind,
              const std::string& one,
              const std::string& many,
              const std::string& remark = "") {
    if(finding.count() != 0)
      defects_.push_back(
          {kind, finding.count(),
           std::to_string(finding.count()) + " " + finding.words(one + remark, many + remark)});
  }

  void check_size() {
    if(soup_.faces.empty())
      defects_.push_back({Mesh_defect::EMPTY, 1, "the mesh has no faces"});
    if(3 * soup_.faces.size() > Soup::largest_number_of_halfedges ||
       soup_.points.size() > Soup::largest_number_of_halfedges)
      defects_.push_back({Mesh_defect::TOO_LARGE, 1, "the mesh has more than 2^32 - 2 halfedges"});
    are_faces_sound_ = defects_.empty();
  }

  void check_points() {
    Finding bad_points;
    for(std::size_t v = 0; v < soup_.points.size(); ++v)
      if(!is_finite(soup_.points[v]))
        bad_points.add([v] { return name_of_vertex(v); });
    report(bad_points, Mesh_defect::NON_FINITE_COORDINATE,
           "vertex has a coordinate that is infinite or not a number",
           "vertices have coordinates that are infinite or not numbers");
  }

  void check_faces() {
    Finding not_triangles, degenerate_faces;
    for(std::size_t f = 0; f < soup_.faces.size(); ++f) {
      const Soup_face& face = soup_.faces[f];
      if(!face.is_triangle())
        not_triangles.add(
            [&] { return name_of_face(f) + " with " + std::to_string(face.size()) + " vertices"; });
      else if(face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
        degenerate_faces.add([f] { return name_of_face(f); });
    }
    report(not_triangles, Mesh_defect::NOT_TRIANGULATED, "face is not a triangle",
           "faces are not triangles");
    report(degenerate_faces, Mesh_defect::DEGENERATE_FACE, "face uses the same vertex twice",
           "faces use the same vertex twice");
    if(not_triangles.count() + degenerate_faces.count() != 0)
      are_faces_sound_ = false;
  }

  bool have_same_direction(std::uint32_t h, std::uint32_t g) const {
    return soup_.source(h) == soup_.source(g);
  }

  void check_edges() {
    Finding boundary, crowded, disoriented;
    edges_->for_each_edge([&](const Edge_table::Edge& edge) {
      const std::uint32_t h = edge.halfedge(0);
      const std::uint32_t g = edge.halfedge(edge.size() - 1);
      if(edge.size() == 1) {
        boundary.add([&] { return edge.name() + " of " + name_of_face(h / 3); });
      } else if(edge.size() > 2) {
        crowded.add([&] { return edge.name_with_faces(); });
      } else if(have_same_direction(h, g)) {
        disoriented.add([&] {
          return edge.name() + " between faces " + std::to_string(h / 3) + " and " +
                 std::to_string(g / 3);
        });
      }
    });
    if(crowded.count() + disoriented.count() > 0)
      report_duplicate_faces();
    report(crowded, Mesh_defect::NON_MANIFOLD_EDGE, "edge has more than two faces",
           "edges have more than two faces");
    report_unwelded(boundary);
    report_orientation(disoriented);
  }

  // Faces with the same three vertices, whatever their order.
  void report_duplicate_faces() {
    const std::vector<Corners_of_face> suspects = suspicious_faces(soup_, *edges_);
    std::vector<std::array<std::uint32_t, 2>> pairs; // a face, and the one before it
    for(std::size_t i = 1; i < suspects.size(); ++i)
      if(suspects[i].first == suspects[i - 1].first)
        pairs.push_back({suspects[i].second, suspects[i - 1].second});
    std::sort(pairs.begin(), pairs.end()); // the smallest face is named
    Finding duplicates;
    for(const auto& [face, same] : pairs)
      duplicates.add([face_number = face, same_number = same] {
        return name_of_face(face_number) + " with the vertices of " + name_of_face(same_number);
      });
    report(duplicates, Mesh_defect::NON_MANIFOLD_EDGE, "face is a duplicate",
           "faces are duplicates");
  }

  // A surface may have a boundary. But where no two faces share a vertex, and edges lie on others,
  // that is a matter of the file.
  void report_unwelded(const Finding& boundary) {
    const std::size_t corners = 3 * soup_.faces.size();
    if(boundary.count() != corners || soup_.faces.size() == 1 || do_faces_share_vertices())
      return;
    Point_merger merger;
    std::vector<std::uint32_t> places; // of the source of each halfedge
    places.reserve(corners);
    for(std::uint32_t h = 0; h < corners; ++h)
      places.push_back(merger.number(soup_.points[soup_.source(h)]));
    if(!do_edges_lie_on_others(places))
      return;
    report(boundary, Mesh_defect::BOUNDARY_EDGE, "boundary edge", "boundary edges",
           ", in " + counted(soup_.faces.size(), "loop", "loops") +
               " of three edges: no two faces share a vertex (merging equal points would "
               "leave " +
               std::to_string(merger.take_points().size()) + " of " + std::to_string(corners) +
               " vertices)");
  }

  bool do_faces_share_vertices() const {
    std::vector<char> is_used(soup_.points.size(), 0);
    for(const Soup_face& face : soup_.faces)
      for(const std::uint32_t v : face) {
        if(is_used[v] != 0)
          return true;
        is_used[v] = 1;
      }
    return false;
  }

  // Where none does, faces touch in points at most, and merging these would join none. Nor would it
  // join a face to others of which it leaves no three vertices.
  static bool do_edges_lie_on_others(const std::vector<std::uint32_t>& places) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(places.size());
    for(std::size_t h = 0; h < places.size(); h += 3) {
      const std::uint32_t a = places[h], b = places[h + 1], c = places[h + 2];
      if(a != b && b != c && c != a)
        edges.insert(edges.end(), {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
    }
    std::sort(edges.begin(), edges.end());
    return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
  }

  void report_orientation(const Finding& disoriented) {
    if(disoriented.count() == 0)
      return;
    const bool can_be_fixed = is_orientable();
    report(disoriented, Mesh_defect::INCONSISTENT_ORIENTATION,
           "edge has two faces with inconsistent orientation",
           "edges have two faces with inconsistent orientation",
           can_be_fixed ? " (flipping faces would fix it)"
                        : " (flipping faces cannot fix it: the surface is not orientable)");
    defects_.back().is_not_orientable = !can_be_fixed;
  }

  // Each face stands for itself and, shifted by the number of faces, for itself flipped. The
  // surface is not orientable where a face turns out to be of one side with its own flipped self.
  bool is_orientable() const {
    const auto number_of_faces = static_cast<std::uint32_t>(soup_.faces.size());
    Disjoint_sets sides(2 * std::size_t(number_of_faces));
    edges_->for_each_edge([&](const Edge_table::Edge& edge) {
      if(edge.size() != 2)
        return;
      const std::uint32_t f = edge.halfedge(0) / 3, g = edge.halfedge(1) / 3;
      const std::uint32_t flip =
          have_same_direction(edge.halfedge(0), edge.halfedge(1)) ? number_of_faces : 0;
      sides.union_set(f, g + flip);
      sides.union_set(f + number_of_faces, g + number_of_faces - flip);
    });
    for(std::uint32_t f = 0; f < number_of_faces; ++f)
      if(sides.find_set(f) == sides.find_set(f + number_of_faces))
        return false;
    return true;
  }

  // The corners at a vertex form fans, from one to the next across an edge; one fan is right. A
  // corner has the number of the halfedge that begins there.
  void check_vertices() {
    Disjoint_sets corners(3 * soup_.faces.size());
    edges_->for_each_edge([&](const Edge_table::Edge& edge) {
      const std::uint32_t h = edge.halfedge(0);
      for(std::size_t i = 1; i < edge.size(); ++i) {
        const std::uint32_t g = edge.halfedge(i);
        const bool is_parallel = have_same_direction(h, g);
        corners.union_set(h, is_parallel ? g : next_in_triangle(g));
        corners.union_set(next_in_triangle(h), is_parallel ? next_in_triangle(g) : g);
      }
    });
    std::vector<std::uint32_t> fans(soup_.points.size(), 0);
    for(std::uint32_t corner = 0; corner < 3 * soup_.faces.size(); ++corner)
      if(corners.find_set(corner) == corner)
        ++fans[soup_.source(corner)];
    Finding pinched;
    for(std::size_t v = 0; v < fans.size(); ++v)
      if(fans[v] > 1)
        pinched.add(
            [&] { return name_of_vertex(v) + " with " + std::to_string(fans[v]) + " fans"; });
    report(pinched, Mesh_defect::NON_MANIFOLD_VERTEX,
           "vertex has faces that form more than one fan",
           "vertices have faces that form more than one fan");
  }

  const Soup& soup_;
  std::vector<Defect> defects_;
  bool are_faces_sound_ = true;
  std::optional<Edge_table> edges_;
};

// Faces that share no edge may be those of a file without common vertices.
bool is_suspicious(const Soup& soup, const Mesh& mesh) {
  return mesh.number_of_edges() == 3 * mesh.number_of_faces() ||
         !std::all_of(soup.points.begin(), soup.points.end(), is_finite);
}

} // namespace

Edge_table::Edge_table(const Soup& soup)
    : first_(soup.points.size() + 1, 0)
    , entries_(3 * soup.faces.size()) {
  for_each_halfedge(soup, [this](std::uint32_t near_vertex, std::uint32_t, std::uint32_t) {
    ++first_[near_vertex];
  });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  // Filling backwards leaves each number at the beginning of its range.
  for_each_halfedge(
      soup, [this](std::uint32_t near_vertex, std::uint32_t far_vertex, std::uint32_t halfedge) {
        entries_[--first_[near_vertex]] = {far_vertex, halfedge};
      });
  for(std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::sort(entries_.begin() + first_[v], entries_.begin() + first_[v + 1],
              [](const Entry& a, const Entry& b) {
                return std::make_pair(a.far_vertex, a.halfedge) <
                       std::make_pair(b.far_vertex, b.halfedge);
              });
}

std::vector<Corners_of_face> suspicious_faces(const Soup& soup, const Edge_table& edges) {
  std::vector<Corners_of_face> suspects;
  edges.for_each_edge([&](const Edge_table::Edge& edge) {
    const bool is_sound =
        edge.size() < 2 ||
        (edge.size() == 2 && soup.source(edge.halfedge(0)) != soup.source(edge.halfedge(1)));
    for(std::size_t i = 0; !is_sound && i < edge.size(); ++i) {
      const std::uint32_t f = edge.halfedge(i) / 3;
      suspects.push_back({{soup.faces[f][0], soup.faces[f][1], soup.faces[f][2]}, f});
      std::sort(suspects.back().first.begin(), suspects.back().first.end());
    }
  });
  std::sort(suspects.begin(), suspects.end());
  suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
  return suspects;
}

std::vector<Defect> diagnose(const Soup& soup) { return Diagnostician(soup).run(); }

Built_mesh build_mesh(const Soup& soup) {
  Built_mesh built;
  try {
    built.mesh = Mesh(soup.points, soup.faces);
    if(is_suspicious(soup, built.mesh))
      built.defects = diagnose(soup);
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception&) {
    built.defects = diagnose(soup); // all of them
    if(built.defects.empty())
      throw;
  }
  return built;
}

} // namespace htloops
