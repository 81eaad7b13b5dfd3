// What `htloops cut --seams` and `--uv` promise: edges of the file alone are cut, and charts keep
// their triangles upright and apart. All is counted exactly, on what is written.

#include "app/solve/charts.h"

#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"
#include "Temporary_folder.h"

#include "app/draw/meshes.h"
#include "app/mend/mesh_reader.h"
#include "app/mend/steps.h"
#include "app/read/input_file.h"
#include "app/read/soup.h"
#include "app/solve/cut_solver.h"
#include "app/write/mesh_writer.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_charts {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Side = std::pair<std::uint32_t, std::uint32_t>;
using htloops::Corners;

/// An OBJ file with texture coordinates.
struct Obj
{
  std::vector<Exact::Point_2> places;
  std::vector<std::vector<std::uint32_t>> vertices, corners; // of faces
};

Obj read_obj(const std::string& text) {
  Obj obj;
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if(word == "vt") {
      double u, v;
      words >> u >> v;
      EXPECT_TRUE(u >= 0. && u <= 1. && v >= 0. && v <= 1.);
      EXPECT_TRUE(u == static_cast<float>(u) && v == static_cast<float>(v));
      obj.places.emplace_back(u, v);
    } else if(word == "f") {
      obj.vertices.emplace_back();
      obj.corners.emplace_back();
      while(words >> word) {
        const std::size_t slash = word.find('/');
        obj.vertices.back().push_back(std::stoul(word) - 1);
        obj.corners.back().push_back(std::stoul(word.substr(slash + 1)) - 1);
      }
    }
  }
  return obj;
}

class Charts_of : public testing::Test
{
protected:
  void SetUp() override {
    if(!htloops::can_make_charts())
      GTEST_SKIP() << "a build without Eigen";
  }

  // Cuts the mesh of a file and writes its charts, as the tool does.
  Obj charts_of(const std::string& name) {
    const htloops::Input_file file(folder_.path(name));
    faces_ = htloops::read_whole_soup(file);
    htloops::Remedies remedies;
    remedies.do_triangulate = true;
    mended_ = htloops::read_mesh(file, remedies);
    htloops::Cut_options options;
    options.avoided = mended_.cuts;
    options.do_cut_spheres = true;
    htloops::Progress progress;
    cut_ = htloops::find_cut(mended_.mesh, options, progress).edges;
    opened_ = htloops::open_mesh(mended_.mesh, cut_);
    charts_ = htloops::make_charts(opened_.soup);
    htloops::export_charts(folder_.path("uv.obj"), faces_, mended_.mesh, opened_, charts_);
    return read_obj(folder_.read("uv.obj"));
  }

  std::vector<Exact::Triangle_2> triangles_in_plane(const Obj& obj) const {
    std::vector<Exact::Triangle_2> triangles;
    for(const auto& [u, v, w] : opened_.soup.triangles)
      triangles.emplace_back(obj.places[u], obj.places[v], obj.places[w]);
    return triangles;
  }

  void expect_upright_and_apart(const Obj& obj) const {
    const std::vector<Exact::Triangle_2> triangles = triangles_in_plane(obj);
    for(const Exact::Triangle_2& t : triangles)
      ASSERT_EQ(t.orientation(), CGAL::LEFT_TURN);
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        if(!CGAL::do_overlap(triangles[i].bbox(), triangles[j].bbox()))
          continue;
        const auto common = CGAL::intersection(triangles[i], triangles[j]);
        ASSERT_FALSE(common && (boost::get<Exact::Triangle_2>(&*common) != nullptr ||
                                boost::get<std::vector<Exact::Point_2>>(&*common) != nullptr))
            << i << " and " << j;
      }
  }

  // Faces have one place at both sides of an edge unless it is cut.
  void expect_seams(const Obj& obj) const {
    std::set<Side> cut;
    for(const htloops::Mesh::Edge_index e : cut_) {
      cut.emplace(mended_.mesh.vertex(e, 0).idx(), mended_.mesh.vertex(e, 1).idx());
      cut.emplace(mended_.mesh.vertex(e, 1).idx(), mended_.mesh.vertex(e, 0).idx());
    }
    std::map<Side, Side> places; // by directed edge of the file
    for(std::size_t f = 0; f < obj.vertices.size(); ++f)
      for(std::size_t i = 0; i < obj.vertices[f].size(); ++i) {
        const std::size_t next = (i + 1) % obj.vertices[f].size();
        places[{obj.vertices[f][i], obj.vertices[f][next]}] = {obj.corners[f][i],
                                                               obj.corners[f][next]};
      }
    for(const Side& side : cut)
      EXPECT_EQ(places.count(side), 1u) << "a cut across a face";
    for(const auto& [side, ends] : places)
      if(const auto other = places.find({side.second, side.first}); other != places.end()) {
        EXPECT_EQ(other->second == std::make_pair(ends.second, ends.first), cut.count(side) == 0);
      }
  }

  void expect_faces_of_file(const Obj& obj) const {
    ASSERT_EQ(obj.vertices.size(), faces_.faces.size());
    htloops::for_each_polygon(faces_, [&](std::size_t f, const Corners& corners) {
      EXPECT_EQ(obj.vertices[f], corners);
    });
  }

  void expect_charts(const std::string& name) {
    SCOPED_TRACE(name);
    const Obj obj = charts_of(name);
    expect_upright_and_apart(obj);
    expect_seams(obj);
    expect_faces_of_file(obj);
  }

  // A square torus of n by n quadrangles, some of them joined to hexagons, whose points are shaken.
  void write_quadrangles(const std::string& name, unsigned n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shake(-0.1, 0.1);
    std::ostringstream text;
    for(unsigned i = 0; i < n; ++i)
      for(unsigned j = 0; j < n; ++j) {
        const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / n;
        text << "v " << (3. + std::cos(b)) * std::cos(a) + shake(random) << ' '
             << (3. + std::cos(b)) * std::sin(a) + shake(random) << ' '
             << std::sin(b) + shake(random) << '\n';
      }
    const auto vertex = [n](unsigned i, unsigned j) { return i % n * n + j % n + 1; };
    for(unsigned i = 0; i < n; ++i)
      for(unsigned j = 0; j < n; ++j) {
        const bool is_joined = j + 2 < n && random() % 4 == 0;
        text << "f " << vertex(i, j) << ' ' << vertex(i + 1, j) << ' ' << vertex(i + 1, j + 1);
        if(is_joined)
          text << ' ' << vertex(i + 1, j + 2) << ' ' << vertex(i, j + 2);
        text << ' ' << vertex(i, j + 1) << '\n';
        j += is_joined;
      }
    folder_.write(name, text.str());
  }

  Temporary_folder folder_;
  htloops::Soup faces_;
  htloops::Mended_mesh mended_;
  std::vector<htloops::Mesh::Edge_index> cut_;
  htloops::Opened_mesh opened_;
  htloops::Charts charts_;
};

TEST_F(Charts_of, generated_meshes) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 2}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    htloops::write_mesh(folder_.path("mesh.off"), soup_of(recipe));
    expect_charts("mesh.off");
  }
}

TEST_F(Charts_of, quadrangles_and_hexagons) {
  for(unsigned seed = 0; seed < 4; ++seed) {
    write_quadrangles("quads.obj", 6 + 2 * seed, seed);
    expect_charts("quads.obj");
    EXPECT_FALSE(mended_.cuts.empty());
    for(const htloops::Mesh::Edge_index e : cut_)
      EXPECT_EQ(mended_.cuts[e.idx()], 0);
  }
}

// Whose farthest vertices are neighbors.
TEST_F(Charts_of, a_tetrahedron_and_a_cube) {
  folder_.write("tetrahedron.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  expect_charts("tetrahedron.off");
  EXPECT_GT(cut_.size(), 1u);
  folder_.write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                            "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  expect_charts("cube.off");
}

// Each has a square of its own.
TEST_F(Charts_of, several_components) {
  std::vector<generators::Soup> soups;
  for(const unsigned seed : {0, 1, 2})
    for(const char* kind : {"sphere", "torus"})
      soups.push_back(soup_of({kind, {200 + 100 * seed, kind[0] == 't' ? 1u : 0u, seed}}));
  htloops::write_mesh(folder_.path("many.off"), generators::disjoint_union(soups));
  expect_charts("many.off");
  EXPECT_EQ(charts_.number, 6u);
}

} // namespace test_htloops_charts
