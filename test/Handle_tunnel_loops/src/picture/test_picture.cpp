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
  EXPECT_GE(written, 4); // on four sides of the one place,
  EXPECT_LE(written, 5); // and one with a line that leads to it, if it is narrow
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

TEST_F(Written_picture, LabelsWithoutRoomHaveALineThatLeadsToThem) {
  htl_picture::Text_layer texts(640, 480, 12.);
  texts.add_ring({320.f, 240.f, 60.f, 2.f, {0, 0, 0}}); // what is beside the place is taken
  ASSERT_TRUE(texts.add_label("8", {255, 0, 0}, {{320, 240}}, [](const auto&) { return 0.; }));
  std::vector<Colour> pixels(640 * 480, Colour{255, 255, 255});
  texts.draw_on(pixels);
  std::size_t red = 0;
  for(const Colour& pixel : pixels)
    red += is_reddish(pixel);
  EXPECT_GT(red, 60u); // pixels, which the letter alone does not have
}

TEST_F(Written_picture, HasAScaleBarOfARoundLength) {
  options.width = 640;
  options.height = 480;
  const Picture plain = draw(cube(), {});
  options.has_scale_bar = true;
  const auto length_of_bar = [&](double size) {
    const Picture picture = draw(cube(size), {});
    int longest = 0; // of dark pixels in a row, in the lower left corner
    for(int y = 400; y < 480; ++y) {
      int run = 0;
      for(int x = 0; x < 200; ++x) {
        run = picture.at(x, y)[0] < 120 ? run + 1 : 0;
        longest = (std::max)(longest, run);
      }
    }
    return longest;
  };
  // The side of a cube is 0.92 of the height at the front, and a little less in the middle.
  const double side = 480. * 0.92 * 0.9;
  EXPECT_NEAR(length_of_bar(1.), 0.2 * side, 0.03 * side);
  EXPECT_NEAR(length_of_bar(0.001), 0.2 * side, 0.03 * side);
  EXPECT_NEAR(length_of_bar(3.), side / 3., 0.03 * side);
}

Line small_loop(Point p, double size) {
  Line loop = {{}, {255, 0, 0}, true};
  for(const auto& [dx, dz] :
      {std::pair{0., 0.}, std::pair{1., 0.}, std::pair{1., 1.}, std::pair{0., 1.}})
    loop.points.push_back({p[0] + size * dx, p[1], p[2] + size * dz});
  return loop;
}

TEST_F(Drawn_picture, HasARingAroundASmallLoopThatIsSeen) {
  options.width = 640;
  options.height = 480;
  options.surface_opacity = 1.;
  const auto reds = [&](const Line& line) { return draw(cube(), {line}).count(is_reddish); };
  const Line speck = small_loop({0.5, 0., 0.5}, 0.01), large = small_loop({0.3, 0., 0.3}, 0.4);
  const Line hidden = small_loop({0.5, 1., 0.5}, 0.01);
  const auto without = reds(speck), of_large = reds(large);
  options.has_rings = true;
  EXPECT_GT(reds(speck), without + 10);
  EXPECT_EQ(reds(large), of_large);
  EXPECT_EQ(reds(hidden), 0);
}

TEST_F(Drawn_picture, LeavesAGapBesideALineThatCrossesOthers) {
  options.width = options.height = 300;
  const Colour green = {0, 255, 0};
  const auto is_green = [](const Colour& c) { return c[1] > c[0] + 40 && c[1] > c[2] + 40; };
  // Upright, and before it or behind it one that lies.
  const auto greens_beside = [&](double y) {
    const Line lying = {{{0.2, 0., 0.5}, {0.8, 0., 0.5}}, {255, 0, 0}, false};
    const Line upright = {{{0.5, y, 0.2}, {0.5, y, 0.8}}, green, false};
    const Picture picture = draw({}, {lying, upright});
    int column = 0;
    for(int i = 0; i < picture.height; ++i)
      column += is_green(picture.at(150, i));
    return column;
  };
  options.line_width_px = 10.;
  // Not only as much as the other covers is missing of that which is behind, but a gap on both
  // sides.
  EXPECT_GE(greens_beside(-0.3) - greens_beside(0.3), 12);
}

TEST_F(Drawn_picture, DrawsTheEdgeOfWhatIsBeforeSomethingElse) {
  // A small square before a large one, both turned to the eye.
  Mesh squares;
  for(const auto& [size, y] : {std::pair{1., 0.}, std::pair{0.4, -0.3}})
    for(const auto& [u, v] :
        {std::pair{-1., -1.}, std::pair{1., -1.}, std::pair{1., 1.}, std::pair{-1., 1.}})
      squares.points.push_back({size * u, y, size * v});
  squares.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const Picture picture = draw(squares);
  const int middle = picture.at(80, 60)[0];
  int darkest = 255;
  for(int x = 30; x < 80; ++x)
    darkest = (std::min)(darkest, int(picture.at(x, 60)[0]));
  EXPECT_LT(darkest, middle - 20);
  // There is none on a flat side.
  EXPECT_NEAR(picture.at(75, 60)[0], middle, 6);
}

// A ridge, the sides of which are hardly turned to the eye.
TEST_F(Drawn_picture, DrawsNoEdgeWhereSteepSidesMeet) {
  Mesh ridge;
  for(const auto& [x, y] : {std::pair{-0.1, 3.}, std::pair{0., 0.}, std::pair{0.1, 6.}})
    for(const double z : {-0.5, 0.5})
      ridge.points.push_back({x, y, z});
  ridge.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  options.width = 320;
  options.height = 240;
  const Picture picture = draw(ridge);
  std::vector<int> row; // of the ridge alone
  for(int x = 0; x < picture.width; ++x)
    if(const Colour c = picture.at(x, 120); !is_white(c))
      row.push_back(c[0]);
  ASSERT_GT(row.size(), 24u);
  const std::size_t n = row.size();
  EXPECT_GE(*std::min_element(row.begin() + n / 8, row.end() - n / 8),
            (std::min)(row[n / 4], row[3 * n / 4]) - 8);
}

TEST_F(Drawn_picture, ShowsSurfacesSideBySideAsOneCameraSeesThem) {
  const Mesh large = cube(), small = cube(0.5);
  options.width = 240;
  const std::vector<Line> none;
  const Picture picture = decoded(htl_picture::encode_picture(
      {{large.points, large.triangles, {}, none}, {small.points, small.triangles, {}, none}},
      options));
  EXPECT_EQ(picture.width, 240);
  const auto covered = [&](int first, int last) {
    int count = 0;
    for(int y = 0; y < picture.height; ++y)
      for(int x = first; x < last; ++x)
        count += !is_white(picture.at(x, y));
    return count;
  };
  EXPECT_NEAR(double(covered(120, 240)), 0.25 * covered(0, 120), 0.05 * covered(0, 120));
}

TEST_F(Drawn_picture, DrawsALineLargeAndCutsAwayWhatIsBeforeIt) {
  const Mesh mesh = cube();
  options.width = 640;
  options.height = 480;
  options.surface_opacity = 1.;
  const std::vector<Line> lines = {small_loop({0.5, 1., 0.5}, 0.02)}; // on the far side
  EXPECT_EQ(draw(mesh, lines).count(is_red), 0);
  const Picture picture = decoded(htl_picture::encode_closeup(
      {{mesh.points, mesh.triangles, {}, lines}}, {lines[0].points}, options));
  int reds = 0, left = 640, right = 0;
  for(int y = 0; y < 480; ++y)
    for(int x = 0; x < 460; ++x) // the small picture of all is on the right
      if(is_red(picture.at(x, y))) {
        ++reds;
        left = (std::min)(left, x);
        right = (std::max)(right, x);
      }
  EXPECT_GT(reds, 1000);
  EXPECT_GT(right - left, 200);
  // All of the cube is there, too, in a corner.
  int covered = 0;
  for(int y = 350; y < 470; ++y)
    for(int x = 470; x < 630; ++x)
      covered += is_white(picture.at(x, y));
  EXPECT_GT(covered, 500);
  EXPECT_LT(covered, 15000);
}

// The second surface has no line, but a red side at the same place.
TEST_F(Drawn_picture, ShowsTheSamePlaceOfSeveralSurfacesLarge) {
  const Mesh mesh = cube();
  options.width = 640;
  options.height = 240;
  options.surface_opacity = 1.;
  const std::vector<Line> lines = {small_loop({0.5, 1., 0.5}, 0.02)}, none;
  std::vector<Colour> colours(mesh.triangles.size(), Colour{0, 0, 255});
  for(std::size_t t = 0; t < colours.size(); ++t)
    if(std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                   [&](std::uint32_t v) { return mesh.points[v][1] == 1.; }))
      colours[t] = {255, 0, 0};
  const Picture picture = decoded(htl_picture::encode_closeup(
      {{mesh.points, mesh.triangles, {}, lines}, {mesh.points, mesh.triangles, colours, none}},
      {lines[0].points}, options));
  EXPECT_EQ(picture.width, 640);
  int of_line = 0, of_side = 0;
  for(int y = 0; y < 160; ++y) // above the small picture of all
    for(int x = 0; x < 320; ++x) {
      of_line += is_red(picture.at(x, y));
      of_side += is_reddish(picture.at(320 + x, y));
    }
  EXPECT_GT(of_line, 100);
  EXPECT_LT(of_line, 320 * 160 / 2);
  EXPECT_EQ(of_side, 320 * 160) << "all that is seen there";
}

// One that goes far to the front, and comes back; its lower end is beside what is drawn large.
TEST_F(Drawn_picture, DrawsThePartsOfALineThatAreNotCutAway) {
  const Mesh mesh = cube();
  options.width = 320;
  options.height = 240;
  options.surface_opacity = 1.;
  Line loop = small_loop({0.5, 1., 0.5}, 0.02);
  loop.colour = {0, 0, 255};
  const auto reds = [&](const Point& p, const Point& q) {
    const std::vector<Line> lines = {loop, {{{0.5, -1., 0.5}, p, q}, {255, 0, 0}, true}};
    return decoded(htl_picture::encode_closeup({{mesh.points, mesh.triangles, {}, lines}},
                                               {loop.points}, options))
        .count(is_red);
  };
  EXPECT_GT(reds({0.495, 1., 0.505}, {0.525, 1., 0.515}),
            200 + reds({0.495, 0.9, 0.505}, {0.525, 0.9, 0.515}));
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
