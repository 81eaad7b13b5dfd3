// A changeable copy is the same mesh, whatever is computed on it.

#include "Meshes_of_soups.h"

#include "app/solve/changeable_mesh.h"
#include "generators/generators.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace test_htloops_changeable_mesh {

using htloops::Changeable_copy;
using htloops::Changeable_mesh;
using htloops::Mesh;
using Loop = CGAL::Handle_tunnel_pair<Changeable_mesh>::Loop;

void expect_same(const Loop& a, const Loop& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.length(), b.length());
  EXPECT_EQ(a.points(), b.points());
  for(std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.steps()[i].halfedge, b.steps()[i].halfedge);
    ASSERT_EQ(a.steps()[i].ratio, b.steps()[i].ratio);
  }
}

TEST(Changeable_mesh, has_the_same_loops) {
  for(const Recipe& recipe : {Recipe{"multi-torus", {3000, 3, 1}}, Recipe{"gyroid", {20000, 6, 2}}})
    for(const std::size_t holes : {0, 4}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << holes << " holes");
      Soup soup = soup_of(recipe);
      if(holes != 0)
        soup = generators::with_holes(soup, {holes, 12, true});
      soup.points.push_back({}); // without faces
      const Mesh mesh = mesh_of<Mesh>(soup);
      const Changeable_copy copy(mesh);
      ASSERT_TRUE(copy.mesh.is_valid());
      const auto expected = find_loops(copy.mesh), found = copy.pairs(find_loops(mesh));
      ASSERT_EQ(found.size(), expected.size());
      for(std::size_t i = 0; i < found.size(); ++i) {
        expect_same(found[i].handle(), expected[i].handle());
        expect_same(found[i].tunnel(), expected[i].tunnel());
      }
    }
}

TEST(Changeable_mesh, becomes_what_it_was) {
  const Mesh mesh = mesh_of<Mesh>(Recipe{"sphere", {320, 0, 0}});
  Changeable_copy copy(mesh);
  const auto gone = copy.mesh.halfedge(Changeable_mesh::Face_index(7));
  CGAL::Euler::remove_face(gone, copy.mesh);
  const htloops::Changed_mesh changed = htloops::changed_mesh(copy.mesh, mesh);
  EXPECT_EQ(changed.mesh.points(), mesh.points());
  ASSERT_EQ(changed.mesh.number_of_faces() + 1, mesh.number_of_faces());
  for(const Mesh::Face_index f : changed.mesh.faces()) {
    const Mesh::Face_index before(static_cast<std::uint32_t>(changed.face_origins[f.idx()]));
    EXPECT_EQ(before.idx(), f.idx() + (f.idx() < 7 ? 0 : 1));
    EXPECT_EQ(changed.mesh.source(changed.mesh.halfedge(f)), mesh.source(mesh.halfedge(before)));
  }
}

} // namespace test_htloops_changeable_mesh
