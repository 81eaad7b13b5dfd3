// Pieces of faces: where they are, how long, and what is beside them.

#include "Flat_mesh_of_soup.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_surface_pieces {

using namespace CGAL::Handle_tunnel_loops::internal;

using Place = std::array<double, 3>;

/// a surface that is drawn out along an axis, so that faces are long and thin, in pieces.
struct Divided_surface
{
  Divided_surface(const Soup& soup, double stretch, double spacing_over_edge)
      : mesh(flat_mesh_of(soup)) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-1., 1.);
    const double edge = norm(mesh.points[mesh.neighbor[0]] - mesh.points[0]);
    for(Place& p : mesh.points) {
      for(double& x : p)
        x += 0.2 * edge * shift(random);
      p[0] *= stretch;
    }
    spacing = spacing_over_edge * edge;
    pieces.emplace(Execution(), mesh, wall, spacing);
  }

  Flat_mesh mesh;
  double spacing;
  Face_tree faces{Execution(), mesh, span_of(mesh.points)};
  Wall wall{mesh, span_of(mesh.points), faces};
  std::optional<Surface_pieces> pieces;
};

template <typename Function> void for_surfaces(const Function& f) {
  const std::array<Soup, 3> soups = {smallest_torus(), soup_of({"torus", 60, 1}),
                                     soup_of({"random", 400, 3})};
  for(const Soup& soup : soups)
    for(const double stretch : {1., 40.})
      for(const double spacing : {0.13, 0.5, 3.})
        f(Divided_surface(soup, stretch, spacing));
}

TEST(Surface_pieces, KnowWhereTheyAre) {
  for_surfaces([](const Divided_surface& surface) {
    const Surface_pieces& pieces = *surface.pieces;
    const Wall& wall = surface.wall;
    for(Index p = 0; p < pieces.size(); ++p) {
      const Index f = pieces.face(p);
      const Place centre = pieces.centre(p);
      ASSERT_EQ(pieces.piece_at(f, centre), p);
      const Place on_face =
          nearest_point(centre, wall.corner(f, 0), wall.corner(f, 1), wall.corner(f, 2));
      ASSERT_LT(norm(on_face - centre), 1e-6 * surface.spacing);
    }
  });
}

TEST(Surface_pieces, AreNotMuchLongerThanTheSpacing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0., 1.);
  for_surfaces([&](const Divided_surface& surface) {
    const Surface_pieces& pieces = *surface.pieces;
    const Wall& wall = surface.wall;
    for(Index f = 0; f < wall.size(); ++f)
      for(int i = 0; i < 50; ++i) {
        const double part = std::sqrt(number(random)), along = number(random);
        const Place base = (1. - along) * wall.corner(f, 1) + along * wall.corner(f, 2);
        const Place point = (1. - part) * wall.corner(f, 0) + part * base;
        const Index piece = pieces.piece_at(f, point);
        ASSERT_EQ(pieces.face(piece), f);
        ASSERT_LT(norm(pieces.centre(piece) - point), 1.3 * surface.spacing);
      }
  });
}

TEST(Surface_pieces, AreBesideWhatIsBesideThem) {
  for_surfaces([](const Divided_surface& surface) {
    const Surface_pieces& pieces = *surface.pieces;
    std::set<std::pair<Index, Index>> pairs;
    Sets_of_indices all(pieces.size()), of_faces(pieces.size());
    for(Index p = 0; p < pieces.size(); ++p)
      pieces.for_each_neighbor(p, [&](Index q) {
        ASSERT_NE(p, q);
        pairs.insert({p, q});
        all.unite(p, q);
        if(pieces.face(p) == pieces.face(q))
          of_faces.unite(p, q);
      });
    for(const auto& [p, q] : pairs)
      ASSERT_EQ(pairs.count({q, p}), 1u) << p << " " << q;
    for(Index p = 1; p < pieces.size(); ++p) {
      ASSERT_EQ(all.find(p), all.find(0));
      ASSERT_TRUE(pieces.face(p) != pieces.face(p - 1) || of_faces.find(p) == of_faces.find(p - 1));
    }
  });
}

} // namespace test_surface_pieces
