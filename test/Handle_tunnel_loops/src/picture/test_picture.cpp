#include "picture/Text_layer.h"
#include "picture/picture.h"

#include "Decoded_png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_picture {

using htl_picture::Colour;
using htl_picture::Line;
using htl_picture::Options;
using htl_picture::Point;
using htl_picture::Triangle;

using Picture = Decoded_png;

Picture decoded(const std::string& png) { return decoded_png(png); }

struct Mesh
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

Mesh cube(double scale = 1.) {
  Mesh mesh;
  for(int i = 0; i < 8; ++i)
    mesh.points.push_back({scale * (i & 1), scale * ((i >> 1) & 1), scale * ((i >> 2) & 1)});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

bool is_white(const Colour& c) { return c == Colour{255, 255, 255}; }
bool is_red(const Colour& c) { return c[0] > 130 && c[1] < 110 && c[2] < 110; }
bool is_reddish(const Colour& c) { return c[0] > c[1] + 40 && c[0] > c[2] + 40; }

/// A line across a side of the unit cube.
Line red_line_at_height(double y) {
  return {{{0.2, y, 0.5}, {0.5, y, 0.5}, {0.8, y, 0.5}}, {255, 0, 0}, false};
}

class Drawn_picture : public testing::Test
{
protected:
  void SetUp() override {
    options.width = 160;
    options.height = 120;
    options.view = {0., -1., 0.}; // onto the side y = 0 of a cube
  }

  Picture draw(const Mesh& mesh, const std::vector<Line>& lines = {}) const {
    return decoded(htl_picture::encode_picture(mesh.points, mesh.triangles, {}, lines, options));
  }

  Options options;
};

TEST_F(Drawn_picture, HasTheSizeAskedFor) {
  const Picture picture = draw(cube());
  EXPECT_EQ(picture.width, 160);
  EXPECT_EQ(picture.height, 120);
}

TEST_F(Drawn_picture, ShowsTheMeshInTheMiddle) {
  const Picture picture = draw(cube());
  EXPECT_FALSE(is_white(picture.middle()));
  EXPECT_TRUE(is_white(picture.at(0, 0)));
  EXPECT_TRUE(is_white(picture.at(159, 119)));
  // A square fills the height but for the margin.
  const auto covered = picture.count([](const Colour& c) { return !is_white(c); });
  EXPECT_NEAR(double(covered), 110. * 110., 400.);
}

TEST_F(Drawn_picture, DoesNotDependOnTheScale) {
  const Picture unit = draw(cube());
  for(double scale : {1e-9, 1e9}) {
    const Picture scaled = draw(cube(scale));
    const auto n =
        std::inner_product(unit.pixels.begin(), unit.pixels.end(), scaled.pixels.begin(), 0,
                           std::plus<>(), [](const Colour& a, const Colour& b) { return a != b; });
    EXPECT_LT(n, 20) << scale;
  }
}

TEST_F(Drawn_picture, LeavesNoGapsBetweenTriangles) {
  Mesh fan; // a square of thin triangles around a point off its middle
  constexpr int n = 400;
  fan.points = {{0.31, 0., 0.67}};
  for(int i = 0; i < n; ++i) {
    const double t = 4. * i / n, s = t - std::floor(t);
    const Point corners[4] = {{s, 0., 0.}, {1., 0., s}, {1. - s, 0., 1.}, {0., 0., 1. - s}};
    fan.points.push_back(corners[int(t)]);
  }
  for(std::uint32_t i = 0; i < n; ++i)
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  const Picture picture = draw(fan);
  for(int y = 10; y < 110; ++y)
    for(int x = 30; x < 130; ++x)
      EXPECT_FALSE(is_white(picture.at(x, y))) << x << ' ' << y;
}

TEST_F(Drawn_picture, ShowsALineOnTheNearSide) {
  const Picture picture = draw(cube(), {red_line_at_height(0.)});
  EXPECT_TRUE(is_red(picture.middle()));
}

TEST_F(Drawn_picture, ShowsALineOnTheFarSideFaintly) {
  const Picture picture = draw(cube(), {red_line_at_height(1.)});
  EXPECT_TRUE(is_reddish(picture.middle()));
  EXPECT_FALSE(is_red(picture.middle()));
}

TEST_F(Drawn_picture, HidesALineBehindAnOpaqueSurface) {
  options.surface_opacity = 1.;
  const Picture picture = draw(cube(), {red_line_at_height(1.)});
  EXPECT_EQ(picture.count(is_reddish), 0);
}

TEST_F(Drawn_picture, DrawsBallsAndTubesAsThickAsTheyAre) {
  options.surface_opacity = 0.;
  for(const double radius : {0.1, 0.2}) {
    Line ball = {{{0.5, 0.5, 0.5}}, {255, 0, 0}, false};
    ball.radii = {radius};
    Line tube = {{{0.1, 0.5, 0.5}, {0.9, 0.5, 0.5}}, {255, 0, 0}, false};
    tube.radii = {0.01, radius};
    // The unit is about 100 pixels at the middle of the cube.
    const double pixels = 100. * radius;
    EXPECT_NEAR(double(draw(cube(), {ball}).count(is_reddish)), 3.14 * pixels * pixels,
                0.25 * 3.14 * pixels * pixels);
    const Picture picture = draw(cube(), {tube});
    const auto height_at = [&picture](int x) {
      int reddish = 0;
      for(int y = 0; y < picture.height; ++y)
        reddish += is_reddish(picture.at(x, y));
      return reddish;
    };
    EXPECT_GT(height_at(115), 2 * height_at(55));
    EXPECT_LE(height_at(115), 2.2 * pixels);
  }
}

TEST_F(Drawn_picture, DrawsALineAsManyTimesAsWide) {
  options.line_width_px = 3.;
  Line line = red_line_at_height(0.);
  line.width = 3.;
  const Picture picture = draw(cube(), {line});
  std::ptrdiff_t reddish = 0;
  for(int y = 0; y < picture.height; ++y)
    reddish += is_reddish(picture.at(picture.width / 2, y));
  EXPECT_NEAR(double(reddish), 9., 1.);
}

TEST_F(Drawn_picture, DrawsLinesAsWideAsAskedFor) {
  for(const double width : {2., 6.}) {
    options.line_width_px = width;
    const Picture picture = draw(cube(), {red_line_at_height(0.)});
    std::ptrdiff_t reddish = 0;
    for(int y = 0; y < picture.height; ++y)
      reddish += is_reddish(picture.at(picture.width / 2, y));
    EXPECT_NEAR(double(reddish), width, 1.);
  }
}

TEST_F(Drawn_picture, ClosesClosedLines) {
  Line triangle = {{{0.1, 0., 0.1}, {0.5, 0., 0.9}, {0.9, 0., 0.1}}, {255, 0, 0}, false};
  const auto open = draw(cube(), {triangle}).count(is_red);
  triangle.closed = true;
  const auto closed = draw(cube(), {triangle}).count(is_red);
  EXPECT_GT(closed, 1.2 * open);
}

TEST_F(Drawn_picture, ShowsALineOfOnePointAsADot) {
  const Line dot = {{{0.5, 0., 0.5}}, {255, 0, 0}, true};
  EXPECT_TRUE(is_red(draw(cube(), {dot}).middle()));
}

TEST_F(Drawn_picture, ColoursTriangles) {
  const Mesh mesh = cube();
  std::vector<Colour> colours(mesh.triangles.size(), Colour{0, 0, 255});
  colours[4] = colours[5] = {255, 0, 0}; // the side y = 0
  const Picture picture =
      decoded(htl_picture::encode_picture(mesh.points, mesh.triangles, colours, {}, options));
  EXPECT_TRUE(is_red(picture.middle()));
}

TEST_F(Drawn_picture, LooksAlongTheUprightDirection) {
  options.view = options.up = {0., 0., 2.};
  EXPECT_FALSE(is_white(draw(cube()).middle()));
}

TEST_F(Drawn_picture, OutlinesLinesThatAreToBeSetOff) {
  Line line = red_line_at_height(0.);
  options.line_width_px = 9.;
  const auto whites = [&] { return draw(cube(), {line}).count(is_white); };
  const auto plain = whites();
  line.is_outlined = true;
  EXPECT_GT(whites(), plain + 100); // two white lines of more than a pixel
}

class Written_picture : public Drawn_picture
{
protected:
  void SetUp() override {
    Drawn_picture::SetUp();
    if(!htl_picture::has_font())
      GTEST_SKIP() << "the build found no font";
    options.width = 640;
    options.height = 480;
  }

  // Where pictures of the same size differ.
  static std::size_t differences(const Picture& a, const Picture& b) {
    std::size_t count = 0;
    for(std::size_t i = 0; i < a.pixels.size(); ++i)
      count += a.pixels[i] != b.pixels[i];
    return count;
  }
};

TEST_F(Written_picture, HasALabelBesideALineThatIsSeen) {
  Line line = red_line_at_height(0.);
  const Picture plain = draw(cube(), {line});
  line.label = "17";
  const Picture labelled = draw(cube(), {line});
  const std::size_t pixels = differences(plain, labelled);
  EXPECT_GT(pixels, 60u);
  EXPECT_LT(pixels, 1000u);
  EXPECT_TRUE(is_red(labelled.middle())); // it does not lie on the line
}

TEST_F(Written_picture, HasNoLabelOfALineBehindIfOthersAreInFront) {
  Line behind = red_line_at_height(1.);
  const Line front = red_line_at_height(0.);
  for(Point& p : behind.points)
    p[2] += 0.2; // beside it, as it is seen
  const Picture plain = draw(cube(), {front, behind});
  behind.label = "17";
  EXPECT_EQ(differences(plain, draw(cube(), {front, behind})), 0u);
  EXPECT_GT(differences(draw(cube(), {behind}), plain), 60u); // alone it has one
}

TEST_F(Written_picture, LabelsDoNotCoverEachOther) {
  htl_picture::Text_layer texts(640, 480, 12.);
  const auto cost = [](const htl_picture::Rectangle& box) { return double(box.x); };
  int written = 0;
  for(int i = 0; i < 20; ++i)
    written += texts.add_label("8", {255, 0, 0}, {{320, 240}}, cost);
  EXPECT_EQ(written, 4); // on four sides of the one place
  EXPECT_TRUE(texts.add_label("8", {255, 0, 0}, {{320, 240}, {100, 100}}, cost));
  EXPECT_FALSE(texts.add_label("8", {255, 0, 0}, {{-50, 0}, {700, 500}}, cost)); // outside
}

TEST_F(Written_picture, HasALegendInACorner) {
  const auto corner = [&] {
    const Picture picture = draw(cube(), {red_line_at_height(0.)});
    std::size_t reds = 0;
    for(int y = 0; y < 60; ++y)
      for(int x = 0; x < 60; ++x)
        reds += is_red(picture.at(x, y));
    return reds;
  };
  EXPECT_EQ(corner(), 0u);
  options.legend = {{{255, 0, 0}, "handle (1)"}};
  EXPECT_GT(corner(), 20u);
}

TEST_F(Written_picture, OfAFewPixelsIsDrawn) {
  options.legend = {{{255, 0, 0}, "handle (1)"}};
  Line line = red_line_at_height(0.);
  line.label = "a label that is wider than the picture";
  for(const int size : {1, 2, 16}) {
    options.width = options.height = size;
    const Picture picture = draw(cube(), {line});
    EXPECT_EQ(picture.width, size);
    EXPECT_EQ(picture.height, size);
  }
}

// Whenever that is: each look is the last one in its turn.
TEST_F(Drawn_picture, CanBeEndedAtAnyLook) {
  struct Enough
  {};
  int looks = 0, last = -1;
  options.look = [&] {
    if(looks++ == last)
      throw Enough();
  };
  draw(cube(), {red_line_at_height(0.)});
  const int all = looks;
  EXPECT_GT(all, 5 * options.height) << "of each step that goes over the rows";
  for(last = 0; last < all; last += 37) {
    looks = 0;
    EXPECT_THROW(draw(cube(), {red_line_at_height(0.)}), Enough);
    EXPECT_EQ(looks, last + 1);
  }
}

TEST_F(Drawn_picture, IsEmptyWithoutAMesh) { EXPECT_EQ(draw({}).count(is_white), 160 * 120); }

TEST_F(Drawn_picture, OfAFlatOrTinyMeshIsDrawn) {
  Mesh mesh = cube();
  const auto background = [&] { return draw(mesh).count(is_white); };
  for(Point& p : mesh.points)
    p[2] = 0.;
  EXPECT_GT(background(), 0.95 * 160 * 120) << "seen from the side";
  for(Point& p : mesh.points)
    p = {1., 2., 3.};
  EXPECT_GT(background(), 0.95 * 160 * 120);
}

TEST_F(Drawn_picture, RefusesWhatItCannotDraw) {
  Mesh mesh = cube();
  EXPECT_THROW(
      htl_picture::encode_picture(mesh.points, mesh.triangles, {Colour{1, 2, 3}}, {}, options),
      std::runtime_error);
  options.width = 0;
  EXPECT_THROW(draw(mesh), std::runtime_error);
  options.width = 160;
  mesh.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(draw(mesh), std::runtime_error);
}

} // namespace test_picture
