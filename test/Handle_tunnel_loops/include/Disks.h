#ifndef HTL_TEST_DISKS_H
#define HTL_TEST_DISKS_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// What a surface is when it is cut open along edges: counted face by face, corner by corner, by
// nothing that the package uses.
template <typename TriangleMesh> class Opened_surface
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Edge = typename Graph_traits::edge_descriptor;
  using Face = typename Graph_traits::face_descriptor;

public:
  template <typename EdgeRange>
  Opened_surface(const TriangleMesh& tm, const EdgeRange& cut)
      : tm_(tm) {
    for(const Edge e : cut) {
      is_unique_ = is_unique_ && cut_.insert(halfedge(e, tm)).second;
      cut_.insert(opposite(halfedge(e, tm), tm));
    }
    for(const Face f : faces(tm))
      if(piece_.count(f) == 0)
        fill(f);
  }

  // Whether no edge is named twice.
  bool is_unique() const { return is_unique_; }
  std::size_t number_of_pieces() const { return size_.size(); }

  // V - E + F, where a vertex counts once for each run of faces around it.
  long euler_characteristic(std::size_t piece) const {
    return size_[piece].corners - size_[piece].edges + size_[piece].faces;
  }
  bool is_disk(std::size_t piece) const {
    return euler_characteristic(piece) == 1 && size_[piece].boundary_cycles == 1;
  }
  bool is_sphere(std::size_t piece) const {
    return euler_characteristic(piece) == 2 && size_[piece].boundary_cycles == 0;
  }
  bool are_disks() const {
    for(std::size_t p = 0; p < size_.size(); ++p)
      if(!is_disk(p))
        return false;
    return is_unique_;
  }
  bool is_on_boundary(Vertex v) const {
    for(const Halfedge h : CGAL::halfedges_around_target(v, tm_))
      if(cut_.count(h) != 0)
        return true;
    return false;
  }

private:
  struct Size
  {
    long corners = 0, edges = 0, faces = 0, boundary_cycles = 0;
  };

  void fill(Face first) {
    const std::size_t piece = size_.size();
    size_.push_back({});
    Size& size = size_.back();
    std::vector<Face> stack = {first};
    std::set<Halfedge> seen_corners, seen_boundary;
    piece_[first] = piece;
    while(!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      ++size.faces;
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, tm_), tm_)) {
        const Halfedge twin = opposite(h, tm_);
        size.corners += is_first_seen(h, seen_corners);
        if(cut_.count(h) != 0) {
          ++size.edges;
          size.boundary_cycles += is_first_of_cycle(h, seen_boundary);
        } else {
          if(h < twin)
            ++size.edges;
          if(piece_.emplace(face(twin, tm_), piece).second)
            stack.push_back(face(twin, tm_));
        }
      }
    }
  }

  // The corner of a face at the target of h, with all those that it hangs together with.
  bool is_first_seen(Halfedge h, std::set<Halfedge>& seen) const {
    if(seen.count(h) != 0)
      return false;
    Halfedge k = h;
    do { // one way around
      seen.insert(k);
      k = next(k, tm_);
      if(cut_.count(k) != 0)
        break;
      k = opposite(k, tm_);
    } while(k != h);
    for(k = h; cut_.count(k) == 0;) { // and the other
      k = prev(opposite(k, tm_), tm_);
      if(!seen.insert(k).second)
        break;
    }
    return true;
  }

  bool is_first_of_cycle(Halfedge h, std::set<Halfedge>& seen) const {
    if(seen.count(h) != 0)
      return false;
    while(seen.insert(h).second) {
      h = next(h, tm_);
      while(cut_.count(h) == 0)
        h = next(opposite(h, tm_), tm_);
    }
    return true;
  }

  const TriangleMesh& tm_;
  std::set<Halfedge> cut_;
  std::map<Face, std::size_t> piece_;
  std::vector<Size> size_;
  bool is_unique_ = true;
};

#endif // HTL_TEST_DISKS_H
