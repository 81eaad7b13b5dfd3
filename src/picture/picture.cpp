// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "picture.h"

#include "Camera.h"
#include "Text_layer.h"
#include "layers.h"
#include "shading.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>

namespace htl_picture {
namespace {

static_assert(sizeof(Colour) == 3, "pixels are handed over as they are");

// libpng, with what it has written and what it says.
class Png
{
public:
  Png()
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, note_error, ignore_warning))
      , info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if(info_ == nullptr)
      throw std::runtime_error("cannot write a picture: libpng does not begin");
    png_set_write_fn(png_, this, append, nullptr);
  }
  ~Png() { png_destroy_write_struct(&png_, &info_); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  void begin(int width, int height) {
    call([&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                   8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
      png_write_info(png_, info_);
    });
  }

  void write_row(const Colour* row) {
    call([&] { png_write_row(png_, reinterpret_cast<png_const_bytep>(row)); });
  }

  std::string end() {
    call([&] { png_write_end(png_, info_); });
    return std::move(content_);
  }

private:
  static void note_error(png_structp png, png_const_charp message) {
    static_cast<Png*>(png_get_error_ptr(png))->error_ = message;
    png_longjmp(png, 1);
  }

  static void ignore_warning(png_structp, png_const_charp) {}

  static void append(png_structp png, png_bytep data, png_size_t size) {
    bool is_good = true;
    try {
      static_cast<Png*>(png_get_io_ptr(png))->content_.append(reinterpret_cast<char*>(data), size);
    } catch(const std::bad_alloc&) {
      is_good = false;
    }
    if(!is_good)
      png_error(png, "out of memory");
  }

  template <typename Call> void call(const Call& use) {
    if(!runs_without_error(use))
      throw std::runtime_error("cannot write a picture: " + error_);
  }

  // The errors of libpng are jumps to here, where nothing has to be destroyed, and nothing is
  // thrown, which not all compilers can do beside a jump.
  template <typename Call> bool runs_without_error(const Call& use) {
    if(setjmp(png_jmpbuf(png_)) != 0)
      return false;
    use();
    return true;
  }

  std::string content_, error_;
  png_structp png_;
  png_infop info_;
};

constexpr int samples = 2; // per pixel, in each direction

/// What is to be drawn.
struct Scene
{
  const std::vector<Point>& points;
  const std::vector<Triangle>& triangles;
  const std::vector<Colour>& triangle_colours; ///< none: all as the options say
  const std::vector<Line>& lines;
};

Camera camera_for(const Scene& scene, const Options& options) {
  std::vector<const std::vector<Point>*> seen = {&scene.points};
  for(const Line& line : scene.lines)
    seen.push_back(&line.points);
  return Camera(seen, options.view, options.up, samples * options.width, samples * options.height);
}

std::vector<Vector_3> points_in_frame(const Camera& camera, const std::vector<Point>& points) {
  std::vector<Vector_3> in_frame;
  in_frame.reserve(points.size());
  for(const Point& point : points)
    in_frame.push_back(camera.in_frame(point));
  return in_frame;
}

std::vector<Projected_point> project(const Camera& camera, const std::vector<Vector_3>& points) {
  std::vector<Projected_point> projected;
  projected.reserve(points.size());
  for(const Vector_3& point : points)
    projected.push_back(camera.project(point));
  return projected;
}

class Painter
{
public:
  Painter(const Scene& scene, const Options& options)
      : scene_(scene)
      , options_(options)
      , camera_(camera_for(scene, options))
      , points_(points_in_frame(camera_, scene.points))
      , projected_(project(camera_, points_))
      , normals_(points_, scene.triangles)
      , surface_(projected_,
                 scene.triangles,
                 samples * options.width,
                 samples * options.height,
                 options.look)
      , lines_(camera_,
               surface_,
               scene.lines,
               float(samples * options.line_width_px / 2.),
               options.look) {}

  std::vector<Colour> paint() {
    const std::vector<float> open = find_openness();
    std::vector<Colour> pixels;
    pixels.reserve(open.size());
    for(int y = 0; y < options_.height; ++y) {
      options_.look();
      for(int x = 0; x < options_.width; ++x)
        pixels.push_back(to_srgb(pixel(samples * x, samples * y, open[pixels.size()])));
    }
    write_on(pixels);
    return pixels;
  }

private:
  /// The triangle at the last sample: the next is likely to show the same.
  struct Recent
  {
    std::uint32_t triangle = Surface_layer::no_triangle;
    std::array<Vector_3, 3> normals;
    std::array<Projected_point, 3> corners;
  };

  /// the normal of the surface seen at a sample, turned to the eye; null if there is no surface.
  Vector_3 normal(int x, int y) {
    const std::uint32_t triangle = surface_.triangle(x, y);
    if(triangle == Surface_layer::no_triangle)
      return {};
    if(recent_.triangle != triangle) {
      recent_ = {triangle, normals_(triangle), {}};
      for(int i = 0; i < 3; ++i)
        recent_.corners[i] = projected_[scene_.triangles[triangle][i]];
    }
    const auto weights = corner_weights(recent_.corners, x + 0.5f, y + 0.5f);
    Vector_3 sum;
    for(int i = 0; i < 3; ++i)
      sum = sum + weights[i] * recent_.normals[i];
    const Vector_3 n = normalized(sum);
    return n.z < 0.f ? -1.f * n : n;
  }

  std::vector<float> find_openness() {
    Seen_surface seen = {options_.width, options_.height, {}, {}};
    for(int y = 0; y < options_.height; ++y) {
      options_.look();
      for(int x = 0; x < options_.width; ++x) {
        const int i = samples * x, j = samples * y;
        seen.normals.push_back(normal(i, j));
        seen.points.push_back(
            seen.is_covered(seen.points.size())
                ? camera_.unproject({i + 0.5f, j + 0.5f, surface_.inverse_depth(i, j)})
                : Vector_3{});
      }
    }
    return openness(seen, 1.f / (samples * camera_.pixel_size_in_middle()), options_.look);
  }

  /// the mean of the samples of a pixel, of which the first is given.
  Vector_3 pixel(int x, int y, float open) {
    if(is_of_one_triangle(x, y))
      return sample(x, y, open);
    Vector_3 sum;
    for(int j = y; j < y + samples; ++j)
      for(int i = x; i < x + samples; ++i)
        sum = sum + sample(i, j, open);
    return (1.f / (samples * samples)) * sum;
  }

  /// whether the samples of a pixel show nothing but one triangle, or nothing at all.
  bool is_of_one_triangle(int x, int y) const {
    for(int j = y; j < y + samples; ++j)
      for(int i = x; i < x + samples; ++i)
        if(surface_.triangle(i, j) != surface_.triangle(x, y) ||
           lines_.in_front(i, j).line != Line_layer::no_line ||
           lines_.behind(i, j).line != Line_layer::no_line)
          return false;
    return true;
  }

  Vector_3 sample(int x, int y, float open) {
    const Line_layer::Sample& front = lines_.in_front(x, y);
    if(front.line != Line_layer::no_line)
      return line_colour(front);

    const std::uint32_t triangle = surface_.triangle(x, y);
    if(triangle == Surface_layer::no_triangle)
      return to_linear(options_.background);
    const Colour& own = scene_.triangle_colours.empty() ? options_.surface_colour
                                                        : scene_.triangle_colours[triangle];
    const Vector_3 surface = shade_surface(to_linear(own), normal(x, y), open);
    const Line_layer::Sample& behind = lines_.behind(x, y);
    if(behind.line == Line_layer::no_line)
      return surface;
    const auto opacity = static_cast<float>(options_.surface_opacity);
    return opacity * surface + (1.f - opacity) * line_colour(behind);
  }

  void write_on(std::vector<Colour>& pixels) const {
    const bool has_labels = std::any_of(scene_.lines.begin(), scene_.lines.end(),
                                        [](const Line& line) { return !line.label.empty(); });
    if(!has_labels && options_.legend.empty())
      return;
    Text_layer texts(options_.width, options_.height, (std::max)(10., options_.height / 44.));
    if(!options_.legend.empty())
      texts.add_legend(options_.legend);
    const auto hidden = [this](const Rectangle& box) { return lines_in(box); };
    std::vector<std::vector<Text_layer::Pixel>> seen;
    for(std::uint32_t i = 0; i < scene_.lines.size(); ++i)
      seen.push_back(places_on(i, true));
    // A label of what is hidden would be read as one of what is in front. Bones are all hidden.
    const bool is_none_seen =
        std::all_of(seen.begin(), seen.end(), [](const auto& places) { return places.empty(); });
    for(std::uint32_t i = 0; i < scene_.lines.size(); ++i)
      if(const Line& line = scene_.lines[i]; !line.label.empty())
        texts.add_label(line.label, line.colour, is_none_seen ? places_on(i, false) : seen[i],
                        hidden);
    texts.draw_on(pixels);
  }

  /// some pixels at which a line lies, or only those at which it is seen; the middle of it first.
  std::vector<Text_layer::Pixel> places_on(std::uint32_t number, bool only_seen) const {
    const Line& line = scene_.lines[number];
    constexpr std::size_t enough = 24;
    std::vector<Text_layer::Pixel> places;
    const std::size_t count = (std::min)(enough, line.points.size());
    for(std::size_t k = 0; k < count; ++k) {
      // From the middle to both ends.
      const std::size_t turn = (k % 2 == 0 ? count - k : count + k) / 2;
      const std::size_t i = turn * line.points.size() / count;
      const Projected_point p = camera_.project(camera_.in_frame(line.points[i]));
      const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
      if(x < 0 || y < 0 || x >= samples * options_.width || y >= samples * options_.height)
        continue;
      if(!only_seen || lines_.in_front(x, y).line == number)
        places.push_back({x / samples, y / samples});
    }
    return places;
  }

  /// how many of some pixels of a rectangle show a line.
  double lines_in(const Rectangle& box) const {
    int count = 0;
    for(int y = box.y; y < box.y + box.height; y += 2)
      for(int x = box.x; x < box.x + box.width; x += 2)
        count += lines_.in_front(samples * x, samples * y).line != Line_layer::no_line;
    return count;
  }

  Vector_3 line_colour(const Line_layer::Sample& sample) const {
    constexpr float border = 0.6f; // of half the width
    const Line& line = scene_.lines[sample.line];
    const float inside = line.is_outlined ? border : 1.f;
    return sample.across > inside ? to_linear({255, 255, 255})
                                  : shade_line(to_linear(line.colour), sample.across / inside);
  }

  const Scene& scene_;
  const Options& options_;
  Camera camera_;
  std::vector<Vector_3> points_;
  std::vector<Projected_point> projected_;
  Corner_normals normals_;
  Surface_layer surface_;
  Line_layer lines_;
  Recent recent_;
};

} // namespace

void check_size(std::size_t width, std::size_t height) {
  constexpr std::size_t largest = 16384, millions = 50;
  if(width < 1 || height < 1 || width > largest || height > largest)
    throw std::runtime_error("no picture: its width and height must be from 1 to " +
                             std::to_string(largest) + " pixels");
  if(width * height > millions * 1000000)
    throw std::runtime_error("no picture: it would have more than " + std::to_string(millions) +
                             " million pixels");
}

std::string encode_picture(const std::vector<Point>& points,
                           const std::vector<Triangle>& triangles,
                           const std::vector<Colour>& triangle_colours,
                           const std::vector<Line>& lines,
                           const Options& options) {
  check_size(options.width, options.height);
  if(!triangle_colours.empty() && triangle_colours.size() != triangles.size())
    throw std::runtime_error("no picture: there must be a colour for each triangle");
  const Scene scene = {points, triangles, triangle_colours, lines};
  const std::vector<Colour> pixels = Painter(scene, options).paint();
  Png png;
  png.begin(options.width, options.height);
  for(int y = 0; y < options.height; ++y) {
    options.look();
    png.write_row(pixels.data() + std::size_t(y) * std::size_t(options.width));
  }
  return png.end();
}

} // namespace htl_picture
