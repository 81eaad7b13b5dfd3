#include "window/window.h"

#include "window/encoding.h"
#include "window/packing.h"
#include "window/page_texts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_window {

using namespace htl_window;

std::string inflated_by_zlib(const std::string& bytes, std::size_t size) {
  z_stream stream{};
  if(inflateInit2(&stream, -15) != Z_OK)
    throw std::runtime_error("zlib");
  std::string result(size + 1, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int state = inflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  inflateEnd(&stream);
  if(state != Z_STREAM_END)
    throw std::runtime_error("not the end of the stream");
  return result;
}

// Reads what the documentation says, as a page does.
class Decoder
{
public:
  Decoder(const Encoded_surface& encoded, bool has_parts)
      : has_parts_(has_parts) {
    std::size_t size = 0;
    for(const std::size_t length : encoded.streams.lengths)
      size += length;
    const std::string bytes = inflated_by_zlib(bytes_of_base64(encoded.streams.text), size);
    EXPECT_EQ(bytes.size(), size);
    std::size_t at = 0;
    for(const std::size_t length : encoded.streams.lengths) {
      streams_.push_back(bytes.substr(at, length));
      at += length;
    }
    EXPECT_EQ(streams_.size(), has_parts ? 6u : 5u);
    positions_.resize(streams_.size());
    int part = 0;
    for(std::uint32_t v = 0; v < encoded.number_of_vertices; ++v) {
      if(v == points.size())
        meet(v == 0 ? Grid::Place{} : points[v - 1]);
      for(std::uint32_t n = number(0); n > 0; --n) {
        const std::uint32_t a = corner(v), b = corner(a);
        triangles.push_back({v, a, b});
        if(has_parts)
          parts.push_back(part += signed_number(5));
      }
    }
    for(std::size_t i = 0; i < streams_.size(); ++i)
      EXPECT_EQ(positions_[i], streams_[i].size()) << "stream " << i << " is read to its end";
  }

  std::vector<Grid::Place> points;
  std::vector<Triangle> triangles;
  std::vector<int> parts;

private:
  std::uint32_t number(std::size_t stream) {
    std::uint32_t value = 0;
    for(int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(streams_[stream].at(positions_[stream]++));
      value |= std::uint32_t(byte & 127) << shift;
      if(byte < 128)
        return value;
    }
  }

  std::int32_t signed_number(std::size_t stream) {
    const std::uint32_t value = number(stream);
    return static_cast<std::int32_t>(value >> 1) ^ -static_cast<std::int32_t>(value & 1);
  }

  void meet(Grid::Place near) {
    for(std::size_t i = 0; i < 3; ++i)
      near[i] += signed_number(2 + i);
    points.push_back(near);
  }

  std::uint32_t corner(std::uint32_t near) {
    const std::uint32_t code = number(1);
    if(code > 0)
      return static_cast<std::uint32_t>(points.size()) - code;
    meet(points[near]);
    return static_cast<std::uint32_t>(points.size() - 1);
  }

  bool has_parts_;
  std::vector<std::string> streams_;
  std::vector<std::size_t> positions_;
};

// A triangle by its places, turned so that the least comes first: it keeps its orientation.
using Placed = std::array<Grid::Place, 3>;

Placed placed(const Grid::Place& a, const Grid::Place& b, const Grid::Place& c) {
  Placed result = {a, b, c};
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

// Triangles between random points of a grid; some points are of no triangle.
Surface random_surface(unsigned seed) {
  std::mt19937 random(seed);
  Surface surface;
  const unsigned points = 3 + random() % 300, triangles = random() % 500;
  for(unsigned i = 0; i < points; ++i)
    surface.points.push_back(
        {double(random() % 1000), double(random() % 7) * 1e300, double(random()) * -1e-9});
  for(unsigned i = 0; i < triangles; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % points);
    const auto b = static_cast<std::uint32_t>((a + 1 + random() % (points - 1)) % points);
    auto c = static_cast<std::uint32_t>(random() % points);
    while(c == a || c == b)
      c = static_cast<std::uint32_t>((c + 1) % points);
    surface.triangles.push_back({a, b, c});
    surface.triangle_parts.push_back(static_cast<std::uint32_t>(random() % 20));
  }
  return surface;
}

TEST(Encoded_surface, IsTheSurface) {
  for(unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene;
    scene.surfaces = {random_surface(seed)};
    Surface& surface = scene.surfaces[0];
    const bool has_parts = seed % 2 == 0 && !surface.triangles.empty();
    if(!has_parts)
      surface.triangle_parts.clear();
    const Grid grid(scene);
    const Decoder decoded(encode_surface(surface, grid), has_parts);
    std::multimap<Placed, int> expected, found;
    std::set<std::uint32_t> used;
    for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      used.insert({a, b, c});
      expected.insert({placed(grid.place_of(surface.points[a]), grid.place_of(surface.points[b]),
                              grid.place_of(surface.points[c])),
                       has_parts ? static_cast<int>(surface.triangle_parts[t]) : 0});
    }
    for(std::size_t t = 0; t < decoded.triangles.size(); ++t) {
      const auto& [a, b, c] = decoded.triangles[t];
      found.insert({placed(decoded.points[a], decoded.points[b], decoded.points[c]),
                    has_parts ? decoded.parts[t] : 0});
    }
    EXPECT_EQ(decoded.points.size(), used.size());
    const auto sorted = [](const std::multimap<Placed, int>& map) {
      std::vector<std::pair<Placed, int>> list(map.begin(), map.end());
      std::sort(list.begin(), list.end());
      return list;
    };
    EXPECT_EQ(sorted(found), sorted(expected));
  }
}

TEST(Grid, HasTheWholeRangeOfNumbers) {
  Scene scene;
  scene.surfaces.resize(1);
  constexpr double most = (std::numeric_limits<double>::max)();
  scene.surfaces[0].points = {{-most, 0., 5.}, {most, 1e-320, 5.}};
  const Grid grid(scene);
  EXPECT_EQ(grid.place_of({-most, 0., 5.}), (Grid::Place{0, 0, 0}));
  EXPECT_EQ(grid.place_of({most, 1e-320, 5.}), (Grid::Place{65535, 65535, 0}));
  EXPECT_EQ(grid.place_of({0., 0., 5.})[0], 32768);
  EXPECT_EQ(grid.size()[0], 1.);
  EXPECT_EQ(grid.size()[2], 0.);
}

TEST(Grid, SurfacesKeepMostOfTheStepsWhereverLinesGo) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].points = {{0., 0., 0.}, {4., 2., 1.}};
  scene.lines.resize(1);
  scene.lines[0].points = {{0., -1e6, 0.}, {2., 1., 1e300}, {5., 1., 0.}};
  const Grid grid(scene);
  EXPECT_EQ(grid.place_of({2., -1e6, 0.})[1], 0);
  EXPECT_EQ(grid.place_of({2., 1., 1e300})[2], 65535);
  EXPECT_EQ(grid.extent(), 5.); // x: from 0 to where a line is; y: from -2 to 2; z: from 0 to 3
  EXPECT_EQ(grid.place_of({4., 0., 1.}), (Grid::Place{52428, 32768, 21845}));
}

TEST(Grid, LinesAloneHaveAllSteps) {
  Scene scene;
  scene.lines.resize(1);
  scene.lines[0].points = {{-7., 0., 0.}, {9., 0., 0.}};
  const Grid grid(scene);
  EXPECT_EQ(grid.extent(), 16.);
  EXPECT_EQ(grid.place_of({9., 0., 0.}), (Grid::Place{65535, 0, 0}));
}

// The examples of RFC 4648.
TEST(Base64, IsThatOfTheStandard) {
  for(const auto& [bytes, text] : {std::pair<const char*, const char*>("", ""),
                                   {"f", "Zg=="},
                                   {"fo", "Zm8="},
                                   {"foo", "Zm9v"},
                                   {"foobar", "Zm9vYmFy"},
                                   {"\xff\xfe\xfd", "//79"}})
  {
    EXPECT_EQ(base64_of(bytes), text);
    EXPECT_EQ(bytes_of_base64(text), bytes);
  }
}

TEST(Base64, GoesOnAfterAnEnd) { EXPECT_EQ(bytes_of_base64("\n Zg==Zm8=Zm9v\nZg=="), "ffofoof"); }

TEST(Deflated, InflatesToWhatItWas) {
  std::mt19937 random(1);
  for(const std::size_t size : {0, 1, 1000, 3000000}) {
    std::string bytes(size, '\0');
    for(char& c : bytes)
      c = static_cast<char>(random() % (1 + random() % 200));
    EXPECT_EQ(inflated_by_zlib(deflated(bytes), size), bytes);
    for(const Frame frame : {Frame::NONE, Frame::ZLIB, Frame::GZIP})
      EXPECT_EQ(inflated(deflated(bytes, frame), frame), bytes);
  }
}

TEST(Inflated, TakesStreamsAfterEachOtherAndNoBrokenOnes) {
  const std::string one = deflated("handle", Frame::GZIP), other = deflated("tunnel", Frame::GZIP);
  EXPECT_EQ(inflated(one + other), "handletunnel");
  EXPECT_EQ(inflated(one + std::string(512, '\0')), "handle"); // as tapes fill up blocks
  EXPECT_FALSE(inflated(one + "x"));
  EXPECT_FALSE(inflated(one.substr(0, one.size() - 1)));
  EXPECT_FALSE(inflated(""));
  EXPECT_FALSE(inflated("handle"));
}

TEST(Inflated, TellsHowMuchThereIsAndEndsWhereThatThrows) {
  const std::string packed = deflated(std::string(std::size_t(1) << 24, '\0'));
  std::size_t largest = 0;
  const auto watch = [&largest](std::size_t size) {
    largest = size;
    if(size > 1000000)
      throw std::length_error("that is enough");
  };
  EXPECT_THROW(inflated(packed, Frame::NONE, watch), std::length_error);
  EXPECT_LT(largest, 2000000u);
}

TEST(Html_text, IsNoMarkup) {
  EXPECT_EQ(html_of("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;");
}

TEST(Page, NeedsNothingButItself) {
  Scene scene;
  scene.title = "</script><b>";
  scene.paragraphs = {"1 < 2"};
  scene.surfaces = {{"surface", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}}};
  scene.groups = {{"</script>", {1, 2, 3}}};
  scene.table.columns = {{"@data@", false}};
  scene.table.rows = {{"\xff not UTF-8 <!--"}};
  scene.table.lengths = {1.};
  const std::string page = page_of(scene);
  for(const char* address : {"http:", "https:", "src=", "@import", "url("})
    EXPECT_EQ(page.find(address), std::string::npos) << address;
  EXPECT_NE(page.find("<p>1 &lt; 2</p>"), std::string::npos);
  EXPECT_NE(page.find(">&lt;/script&gt;&lt;b&gt;</h1>"), std::string::npos);
  // What is between the tags of the scene is JSON, and as it was given.
  const std::string begin = "<script type=\"application/json\" id=\"scene\">";
  const std::size_t at = page.find(begin) + begin.size();
  const auto json = nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
  EXPECT_EQ(json["groups"][0]["name"], "</script>");
  EXPECT_EQ(json["columns"][0]["name"], "@data@");
  EXPECT_EQ(json["surfaces"][0]["vertices"], 3);
}

TEST(Page, HasLittleCode) {
  std::string all;
  for(const std::string_view script : page_scripts)
    all += script;
  EXPECT_LT(all.size(), 100000u);
  uLongf size = compressBound(static_cast<uLong>(all.size()));
  std::vector<Bytef> packed(size);
  ASSERT_EQ(compress2(packed.data(), &size, reinterpret_cast<const Bytef*>(all.data()),
                      static_cast<uLong>(all.size()), Z_BEST_COMPRESSION),
            Z_OK);
  EXPECT_LT(size, 30000u);
}

} // namespace test_window
