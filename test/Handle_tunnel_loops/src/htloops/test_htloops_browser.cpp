#include "app/draw/pages.h"

#include "Browser.h"
#include "Meshes_of_soups.h"
#include "Temporary_folder.h"

#include "app/draw/scenes.h"
#include "app/solve/backends.h"
#include "app/solve/skeleton_solver.h"
#include "app/write/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

// Pages as a person sees them who opens them: in a browser. Skipped where there is none.

namespace test_htloops_browser {

using htl_scene::Colour;
using htloops::Mesh;
using Json = Browser::Json;

constexpr int width = 1200, height = 800;

bool is_like(const Colour& colour, const Colour& expected, int tolerance = 40) {
  for(int i = 0; i < 3; ++i)
    if(std::abs(colour[i] - expected[i]) > tolerance)
      return false;
  return true;
}

class Page : public testing::Test
{
protected:
  static void SetUpTestSuite() {
    if(!Browser::program().empty())
      browser_ = new Browser(width, height);
  }

  static void TearDownTestSuite() {
    delete browser_;
    browser_ = nullptr;
  }

  void SetUp() override {
    if(browser_ == nullptr)
      GTEST_SKIP() << "there is no Chromium";
  }

  static Browser& browser() { return *browser_; }

  void open(const Mesh& mesh, const htloops::View& view = {}) {
    htloops::Progress told;
    answer_ = htloops::host_backend.solve(mesh, {}, told);
    listing_ = htloops::list_pairs(mesh, answer_);
    const std::string file = folder_.path("page.html");
    htloops::write_page(file, htloops::scene_of_loops(view, "a <mesh>.off", mesh, answer_, listing_,
                                                      "one\ntwo & <b>"));
    browser().open(file, "document.body?.classList.contains('ready') === true");
    settle();
  }

  // Until nothing moves any more, and all is drawn.
  static void settle() { browser().evaluate("htloops.viewer.settled()"); }

  static Decoded_png screenshot() {
    settle();
    return browser().screenshot();
  }

  // Nothing but the page itself was asked for, and the console is empty.
  static void expect_quiet() {
    for(const std::string& error : browser().errors)
      ADD_FAILURE() << error;
    EXPECT_EQ(browser().requests.size(), 1u);
    EXPECT_EQ(browser().requests[0].substr(0, 7), "file://");
  }

  // Where in the window the points of a line are seen.
  static std::vector<std::array<double, 2>> places_of_line(std::size_t line) {
    std::vector<std::array<double, 2>> places;
    const Json json = browser().evaluate(
        "(() => { const { viewer, scene } = htloops, line = scene.lines[" + std::to_string(line) +
        "]; const box = viewer.canvas.getBoundingClientRect(), places = [];"
        "for(let i = line.first; i <= line.last; ++i) {"
        "  const [x, y] = viewer.project(viewer.pointOfLine(i)); places.push([x + box.x, y + "
        "box.y]); }"
        "return places; })()");
    for(const Json& place : json)
      places.push_back({place[0], place[1]});
    return places;
  }

  static Colour colour_at(const Decoded_png& picture, const std::array<double, 2>& place) {
    const auto inside = [](double x, int size) {
      return std::min(std::max(static_cast<int>(x), 0), size - 1);
    };
    return picture.at(inside(place[0], picture.width), inside(place[1], picture.height));
  }

  // How many points of a line are seen in its colour.
  static std::size_t
  number_in_colour(const Decoded_png& picture, std::size_t line, const Colour& colour) {
    std::size_t number = 0;
    for(const auto& place : places_of_line(line))
      number += is_like(colour_at(picture, place), colour) ? 1 : 0;
    return number;
  }

  // How often a line goes from being seen in its colour to not being so, step by step of a pixel.
  static int number_of_ends(const Decoded_png& picture, std::size_t line, const Colour& colour) {
    const auto places = places_of_line(line);
    int ends = 0;
    bool was_seen = false;
    for(std::size_t i = 1; i < places.size(); ++i) {
      const auto& [x, y] = places[i - 1];
      const auto& [u, v] = places[i];
      const int steps = static_cast<int>(std::hypot(u - x, v - y)) + 1;
      for(int k = 0; k < steps; ++k) {
        const double t = double(k) / steps;
        const bool is_seen =
            is_like(colour_at(picture, {x + t * (u - x), y + t * (v - y)}), colour);
        ends += was_seen && !is_seen ? 1 : 0;
        was_seen = is_seen;
      }
    }
    return ends;
  }

  // The middle of an element.
  static std::array<double, 2> place_of(const std::string& element) {
    const Json box = browser().evaluate("(() => { const b = " + element +
                                        ".getBoundingClientRect(); return [b.x + b.width / 2, "
                                        "b.y + b.height / 2]; })()");
    return {box[0], box[1]};
  }

  static void click(const std::string& element) {
    const auto [x, y] = place_of(element);
    browser().click(x, y);
  }

  static int lit_row() { return browser().evaluate("htloops.page.lit"); }

  static void set_slider(const std::string& id, const std::string& value) {
    browser().evaluate("(() => { const s = document.getElementById('" + id +
                       "'); s.value = " + value + "; s.dispatchEvent(new Event('input')); })()");
  }

  static std::string row(std::size_t i) {
    return "document.getElementById('rows').children[" + std::to_string(i) + "]";
  }

  const Temporary_folder folder_;
  htloops::Answer answer_;
  htloops::Pair_listing listing_;

private:
  static inline Browser* browser_ = nullptr;
};

const Colour handle_colour = htloops::colour_of(CGAL::Loop_type::HANDLE);
const Colour tunnel_colour = htloops::colour_of(CGAL::Loop_type::TUNNEL);

class Pages : public Page, public testing::WithParamInterface<Recipe>
{};

TEST_P(Pages, ShowLoopsWhereTheyAre) {
  const Mesh mesh = mesh_of<Mesh>(GetParam());
  open(mesh);
  expect_quiet();
  const Decoded_png picture = screenshot();
  std::size_t seen = 0, seen_handles = 0;
  for(std::size_t line = 0; line < 2 * listing_.size(); ++line) {
    const std::size_t number =
        number_in_colour(picture, line, line % 2 == 0 ? handle_colour : tunnel_colour);
    seen += number > 0 ? 1 : 0;
    seen_handles += number > 0 && line % 2 == 0 ? 1 : 0;
  }
  EXPECT_GT(seen_handles, 0u);
  EXPECT_GE(seen, listing_.size()); // of the others some are behind the surface
  // The surface is on the page as it is in the file.
  EXPECT_EQ(browser().evaluate("htloops.scene.surfaces[0].vertices"), mesh.number_of_vertices());
  EXPECT_EQ(browser().evaluate("htloops.scene.surfaces[0].faces"), mesh.number_of_faces());
  EXPECT_EQ(browser().evaluate("document.querySelectorAll('#rows tr').length"), listing_.size());
  EXPECT_EQ(browser().evaluate("document.querySelector('h1').textContent"),
            "Handle and tunnel loops of a <mesh>.off");
  EXPECT_EQ(browser().evaluate("document.querySelector('header summary').textContent"), "one");
  EXPECT_EQ(browser().evaluate("document.querySelector('header p').textContent"), "two & <b>");
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Pages,
                         testing::Values(Recipe{"torus", {2000, 1, 0}},
                                         Recipe{"multi-torus", {6000, 3, 0}},
                                         Recipe{"gyroid", {20000, 6, 0}},
                                         Recipe{"chain", {6000, 4, 0}},
                                         Recipe{"plates", {3000, 5, 0}}));

TEST_F(Page, loops_that_are_seen_have_no_gaps) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}), {{0.6, -1., 0.5}, {0., 0., 1.}, {}});
  const Decoded_png picture = screenshot();
  for(std::size_t line = 0; line < 6; ++line)
    EXPECT_LE(number_of_ends(picture, line, line % 2 == 0 ? handle_colour : tunnel_colour), 7)
        << "line " << line;
}

TEST_F(Page, a_click_on_a_row_centres_and_lights_its_loops) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  click(row(1));
  EXPECT_EQ(lit_row(), 1);
  EXPECT_EQ(browser().evaluate(row(1) + ".classList.contains('lit')"), true);
  EXPECT_EQ(browser().evaluate(row(0) + ".classList.contains('lit')"), false);
  settle();
  // Both loops of the pair together are in the middle of the canvas.
  const Json canvas = browser().evaluate("[htloops.viewer.canvas.clientWidth / 2, "
                                         "htloops.viewer.canvas.clientHeight / 2]");
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for(const std::size_t line : {2u, 3u})
    for(const auto& place : places_of_line(line))
      for(int i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], place[i]);
        high[i] = std::max(high[i], place[i]);
      }
  EXPECT_NEAR((low[0] + high[0]) / 2., double(canvas[0]), 0.15 * width);
  EXPECT_NEAR((low[1] + high[1]) / 2., double(canvas[1]), 0.15 * height);
  EXPECT_GT(std::max(high[0] - low[0], high[1] - low[1]), 0.15 * height);
  expect_quiet();
}

// Insides are brownish; a loop that is behind the surface is paler than it is on the list.
TEST_F(Page, a_row_is_looked_at_from_where_its_loops_are_seen) {
  open(mesh_of<Mesh>(Recipe{"gyroid", {20000, 6, 0}}));
  for(std::size_t i = 0; i < listing_.size(); ++i) {
    browser().evaluate("htloops.page.light(" + std::to_string(i) + ", true)");
    const Decoded_png picture = screenshot();
    EXPECT_GT(number_in_colour(picture, 2 * i, handle_colour) +
                  number_in_colour(picture, 2 * i + 1, tunnel_colour),
              0u)
        << "row " << i;
    const auto brownish =
        picture.count([](const Colour& c) { return c[0] - c[2] > 15 && c[0] - c[2] < 45; });
    EXPECT_LT(brownish, width * height / 8) << "row " << i;
  }
  expect_quiet();
}

TEST_F(Page, a_click_on_a_loop_lights_its_row_and_one_beside_none) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  const Decoded_png picture = screenshot();
  std::size_t tried = 0;
  for(std::size_t line = 0; line < 6; ++line)
    for(const auto& place : places_of_line(line))
      if(is_like(colour_at(picture, place), line % 2 == 0 ? handle_colour : tunnel_colour, 12)) {
        browser().click(place[0], place[1]);
        EXPECT_EQ(lit_row(), static_cast<int>(line / 2)) << "line " << line;
        ++tried;
        break;
      }
  EXPECT_GE(tried, 3u);
  browser().click(5., 5.);
  EXPECT_EQ(lit_row(), -1);
  expect_quiet();
}

TEST_F(Page, sliders_and_switches_hide_and_show) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  const auto shown_rows = [] {
    return browser().evaluate(
        "[...document.querySelectorAll('#rows tr')].filter(r => !r.hidden).length");
  };
  const auto pixels = [](const Colour& colour) {
    return screenshot().count([&](const Colour& c) { return is_like(c, colour, 10); });
  };
  EXPECT_EQ(shown_rows(), 3);
  const auto handles = pixels(handle_colour), tunnels = pixels(tunnel_colour);
  EXPECT_GT(handles, 100);
  EXPECT_GT(tunnels, 100);
  click("document.getElementById('group0')");
  EXPECT_LT(pixels(handle_colour), handles / 2); // the legend's own mark stays
  EXPECT_GT(pixels(tunnel_colour), tunnels * 9 / 10);
  click("document.getElementById('group0')");
  EXPECT_GT(pixels(handle_colour), handles * 9 / 10);
  set_slider("longest", "0");
  EXPECT_LT(static_cast<int>(shown_rows()), 3);
  EXPECT_LT(pixels(handle_colour), handles * 9 / 10);
  set_slider("longest", "100");
  EXPECT_EQ(shown_rows(), 3);
  expect_quiet();
}

TEST_F(Page, the_surface_is_cut_and_made_transparent) {
  open(mesh_of<Mesh>(Recipe{"torus", {2000, 1, 0}}));
  const auto white = [] {
    return screenshot().count([](const Colour& c) { return c == Colour{255, 255, 255}; });
  };
  const auto before = white();
  set_slider("cut", "500");
  EXPECT_GT(white(), before + 5000);
  set_slider("cut", "1000");
  EXPECT_EQ(white(), before);
  set_slider("opacity", "0");
  EXPECT_GT(white(), before + 20000);
  expect_quiet();
}

TEST_F(Page, turns_and_moves_with_the_mouse_and_by_keys) {
  open(mesh_of<Mesh>(Recipe{"torus", {2000, 1, 0}}));
  const auto view = [] { return browser().evaluate("[...htloops.viewer.camera.back]"); };
  const Json at_first = view();
  browser().move_mouse(300., 300., false);
  browser().press(300., 300.);
  browser().move_mouse(380., 330., true);
  browser().release(380., 330.);
  const Json dragged = view();
  EXPECT_NE(dragged, at_first);
  EXPECT_EQ(lit_row(), -1); // that was no click
  browser().key("ArrowLeft");
  EXPECT_NE(view(), dragged);
  const double distance = browser().evaluate("htloops.viewer.camera.distance");
  browser().key("+");
  EXPECT_LT(double(browser().evaluate("htloops.viewer.camera.distance")), distance);
  browser().key("n");
  EXPECT_EQ(lit_row(), 0);
  settle();
  browser().key("0");
  settle();
  EXPECT_EQ(view(), at_first);
  EXPECT_EQ(lit_row(), 0); // what was selected stays
  browser().key("Escape");
  EXPECT_EQ(lit_row(), -1);
  expect_quiet();
}

TEST_F(Page, turns_and_zooms_with_fingers) {
  open(mesh_of<Mesh>(Recipe{"torus", {2000, 1, 0}}));
  const auto view = [] { return browser().evaluate("[...htloops.viewer.camera.back]"); };
  const auto distance = [] { return double(browser().evaluate("htloops.viewer.camera.distance")); };
  const Json at_first = view();
  const double far = distance();
  browser().touch("touchStart", {{300., 300.}});
  browser().touch("touchMove", {{340., 310.}});
  browser().touch("touchMove", {{380., 330.}});
  browser().touch("touchEnd", {});
  const Json dragged = view();
  EXPECT_NE(dragged, at_first);
  EXPECT_EQ(lit_row(), -1);
  EXPECT_EQ(distance(), far);
  browser().touch("touchStart", {{270., 300.}, {330., 300.}});
  browser().touch("touchMove", {{240., 300.}, {360., 300.}});
  browser().touch("touchMove", {{210., 300.}, {390., 300.}});
  browser().touch("touchEnd", {});
  EXPECT_LT(distance(), far / 2.); // three times as far from each other
  EXPECT_EQ(lit_row(), -1);
  expect_quiet();
}

TEST_F(Page, chosen_rows_become_an_argument_of_remove) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  const auto choice = [] { return browser().evaluate("document.getElementById('choice').value"); };
  EXPECT_EQ(choice(), "");
  click(row(2) + ".querySelector('input')");
  click(row(0) + ".querySelector('input')");
  EXPECT_EQ(lit_row(), -1); // choosing is not looking
  EXPECT_EQ(choice(),
            "--pairs " + std::to_string(listing_[0].pair) + "," + std::to_string(listing_[2].pair));
  click("document.getElementById('clear')");
  EXPECT_EQ(choice(), "");
  expect_quiet();
}

TEST_F(Page, it_is_told_that_chosen_rows_are_hidden) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  const auto count = [] {
    return browser().evaluate("document.getElementById('count').textContent");
  };
  EXPECT_EQ(count(), "3 of 3 shown");
  click(row(2) + ".querySelector('input')");
  set_slider("longest", "0");
  EXPECT_EQ(count(), "1 of 3 shown; 1 of 1 chosen are hidden");
  expect_quiet();
}

TEST_F(Page, keys_work_after_a_switch_or_a_slider_was_used) {
  open(mesh_of<Mesh>(Recipe{"multi-torus", {6000, 3, 0}}));
  click("document.getElementById('group0')");
  browser().key("n");
  EXPECT_EQ(lit_row(), 0);
  click("document.querySelector('.menu summary')");
  click("document.getElementById('opacity')");
  browser().key("n");
  EXPECT_EQ(lit_row(), 1);
  click("document.getElementById('choice')");
  browser().key("n");
  EXPECT_EQ(lit_row(), 1);
  expect_quiet();
}

TEST_F(Page, places_are_sorted_by_their_first_number) {
  open(mesh_of<Mesh>(Recipe{"lattice", {6000, 5, 1}}));
  click("document.querySelectorAll('#head button')[4]");
  std::vector<double> numbers;
  for(const Json& text : browser().evaluate(
          "[...document.querySelectorAll('#rows tr')].map(r => r.children[5].textContent)"))
    numbers.push_back(std::stod(std::string(text).substr(1)));
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
  expect_quiet();
}

TEST_F(Page, bones_are_seen_through_the_surface_thin_or_thick) {
  const Mesh mesh = mesh_of<Mesh>(Recipe{"torus", {2000, 1, 0}});
  htloops::Progress told;
  const htloops::Skeleton_answer answer = htloops::find_skeleton(mesh, {}, told);
  const std::string file = folder_.path("bones.html");
  htloops::write_page(file, htloops::scene_of_skeleton({}, "a.off", mesh, answer, "one"));
  browser().open(file, "document.body?.classList.contains('ready') === true");
  const auto orange = [] {
    return screenshot().count([](const Colour& c) { return c[0] > c[2] + 60; });
  };
  const auto thin = orange();
  EXPECT_GT(thin, 1000);
  browser().evaluate("document.getElementById('thick').click()");
  EXPECT_GT(orange(), 5 * thin);
  set_slider("opacity", "100");
  EXPECT_LT(orange(), 2 * thin);
  expect_quiet();
}

TEST_F(Page, the_table_is_sorted_by_a_column) {
  open(mesh_of<Mesh>(Recipe{"lattice", {6000, 5, 1}}));
  const auto column = [](int i) {
    std::vector<double> numbers;
    for(const Json& text : browser().evaluate("[...document.querySelectorAll('#rows tr')].map(r => "
                                              "r.children[" +
                                              std::to_string(i) + "].textContent)"))
      numbers.push_back(std::stod(std::string(text)));
    return numbers;
  };
  const std::string button = "document.querySelectorAll('#head button')[2]"; // tunnels
  click(button);
  const std::vector<double> up = column(3);
  EXPECT_TRUE(std::is_sorted(up.begin(), up.end()));
  click(button);
  const std::vector<double> down = column(3);
  EXPECT_TRUE(std::is_sorted(down.rbegin(), down.rend()));
  expect_quiet();
}

} // namespace test_htloops_browser
