#ifndef HTL_TEST_GEODESIC_ANGLES_H
#define HTL_TEST_GEODESIC_ANGLES_H

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// How far a loop is from a closed geodesic: on edges it should be straight, and at vertices neither
// side should span less than a straight angle. By angles, without laying out any triangle.

namespace geodesic_angles {

using namespace CGAL::Handle_tunnel_loops::internal;

constexpr double straight_angle = 3.14159265358979323846;

inline double angle(const Vector& a, const Vector& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// The directions at a vertex as angles, counterclockwise from its first neighbour.
class Directions
{
public:
  Directions(const Flat_mesh& mesh, Index v)
      : mesh_(mesh)
      , v_(v)
      , sums_(1, 0.) {
    const Ring ring = mesh.ring(v);
    for(Index p = 0; p < ring.size(); ++p)
      sums_.push_back(sums_.back() + angle(to(ring[p]), to(ring[ring.next(p)])));
  }

  double total() const { return sums_.back(); }

  // To a point on the face to the left of the edge to u.
  double operator()(Index u, const Vector& point) const {
    return sums_[mesh_.ring(v_).position(u)] + angle(to(u), point - mesh_.points[v_]);
  }

private:
  Vector to(Index u) const { return mesh_.points[u] - mesh_.points[v_]; }

  const Flat_mesh& mesh_;
  Index v_;
  std::vector<double> sums_;
};

class Largest_bend
{
public:
  Largest_bend(const Flat_mesh& mesh, const Crossing_loop& loop)
      : mesh_(mesh)
      , loop_(loop) {
    const std::size_t n = loop.size();
    std::size_t start = 0; // not in the middle of a run of crossings at one vertex
    while(start < n && vertex(start) != no_index && vertex(start) == vertex((start + n - 1) % n))
      ++start;
    for(std::size_t i = start; i < start + n;) {
      std::size_t end = i + 1;
      if(vertex(i % n) == no_index)
        at_edge(i % n);
      else {
        while(end < start + n && vertex(end % n) == vertex(i % n))
          ++end;
        at_vertex(i % n, (end - 1) % n);
      }
      i = end;
    }
  }

  double at_edges() const { return at_edges_; }
  double at_vertices() const { return at_vertices_; }

private:
  Index vertex(std::size_t i) const {
    const Crossing& c = loop_[i];
    return c.ratio == 0. ? c.left : c.ratio == 1. ? c.right : no_index;
  }
  std::size_t before(std::size_t i) const { return i == 0 ? loop_.size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == loop_.size() ? 0 : i + 1; }
  Vector at(std::size_t i) const { return position(mesh_, loop_[i]); }

  void at_edge(std::size_t i) {
    const Vector edge = mesh_.points[loop_[i].right] - mesh_.points[loop_[i].left];
    const Vector in = at(i) - at(before(i)), out = at(after(i)) - at(i);
    // Of a step without length there is no direction.
    if(norm(in) > 1e-6 * norm(edge) && norm(out) > 1e-6 * norm(edge))
      at_edges_ = (std::max)(at_edges_, std::abs(angle(in, edge) - angle(out, edge)));
  }

  // The crossings from first to last are all at one vertex.
  void at_vertex(std::size_t first, std::size_t last) {
    const Index v = vertex(first);
    const Directions direction(mesh_, v);
    const double in = direction(first_corner(v, before(first)), at(before(first)));
    const double out = direction(first_corner(v, last), at(after(last)));
    double span = std::fmod(in - out + 2. * direction.total(), direction.total());
    span = (std::min)(span, direction.total() - span);
    at_vertices_ = (std::max)(at_vertices_, straight_angle - span);
  }

  // Of the triangle ahead of a crossing, which has the corner v, the corner that comes after v.
  Index first_corner(Index v, std::size_t i) const {
    const Index left = loop_[i].left, right = loop_[i].right, apex = apex_ahead(mesh_, loop_[i]);
    return v == left ? right : v == right ? apex : left;
  }

  const Flat_mesh& mesh_;
  const Crossing_loop& loop_;
  double at_edges_ = 0., at_vertices_ = 0.;
};

} // namespace geodesic_angles

#endif // HTL_TEST_GEODESIC_ANGLES_H
