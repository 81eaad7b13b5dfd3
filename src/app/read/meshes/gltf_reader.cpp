// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "failure.h"
#include "read/json_errors.h"
#include "read/meshes/readers.h"
#include "read/sources.h"
#include "read/unpacking.h"
#include "system/files.h"

#include <CGAL/Aff_transformation_3.h>

#include <boost/algorithm/string/predicate.hpp>

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace htloops {
namespace {

using Transform = CGAL::Aff_transformation_3<Kernel>;

// Of the turn that a unit quaternion is, between a scale and a shift.
Transform transform_of(const std::array<double, 4>& q,
                       const std::array<double, 3>& scale,
                       const std::array<double, 3>& shift) {
  const auto& [x, y, z, w] = q;
  const double turn[3][3] = {
      {1. - 2. * (y * y + z * z), 2. * (x * y - z * w), 2. * (x * z + y * w)},
      {2. * (x * y + z * w), 1. - 2. * (x * x + z * z), 2. * (y * z - x * w)},
      {2. * (x * z - y * w), 2. * (y * z + x * w), 1. - 2. * (x * x + y * y)}};
  const auto entry = [&](int i, int j) { return turn[i][j] * scale[static_cast<std::size_t>(j)]; };
  return {entry(0, 0), entry(0, 1), entry(0, 2), shift[0],    entry(1, 0), entry(1, 1),
          entry(1, 2), shift[1],    entry(2, 0), entry(2, 1), entry(2, 2), shift[2]};
}

template <std::size_t n>
std::array<double, n> filled(const std::vector<double>& numbers, std::array<double, n> otherwise) {
  if(numbers.size() == n)
    std::copy(numbers.begin(), numbers.end(), otherwise.begin());
  return otherwise;
}

Transform transform_of(const tinygltf::Node& node) {
  if(node.matrix.size() == 16) { // column by column
    const auto& m = node.matrix;
    return {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]};
  }
  return transform_of(filled<4>(node.rotation, {0., 0., 0., 1.}),
                      filled<3>(node.scale, {1., 1., 1.}),
                      filled<3>(node.translation, {0., 0., 0.}));
}

// Nothing of a picture is needed.
bool skip_image(tinygltf::Image*,
                const int,
                std::string*,
                std::string*,
                int,
                int,
                const unsigned char*,
                int,
                void*) {
  return true;
}

// A buffer is a file in the folder of the text, or below: not one that a stranger wants to see.
bool is_below(const std::string& folder, const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path rest =
      folder.empty() ? path_of(path) : path_of(path).lexically_relative(path_of(folder));
  return !rest.empty() && rest.is_relative() &&
         std::none_of(rest.begin(), rest.end(), [](const fs::path& part) { return part == ".."; });
}

bool is_buffer_there(const std::string& path, void* folder) {
  std::error_code error;
  return is_below(*static_cast<const std::string*>(folder), path) &&
         std::filesystem::is_regular_file(path_of(path), error);
}

// The library would have a shell read the name.
std::string same_path(const std::string& path, void*) { return path; }

bool read_buffer(std::vector<unsigned char>* bytes,
                 std::string* error,
                 const std::string& path,
                 void* folder) {
  if(!is_buffer_there(path, folder))
    return false;
  try {
    const Input_file file(path);
    bytes->assign(file.content().begin(), file.content().end());
    return true;
  } catch(const Failure& failure) {
    *error += failure.what();
    return false;
  }
}

class Gltf_reader
{
public:
  explicit Gltf_reader(const Input_file& file)
      : file_(file) {}

  Soup read() {
    load();
    check_extensions();
    if(model_.nodes.empty())
      for(std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh)
        add_mesh(static_cast<int>(mesh), Transform(CGAL::IDENTITY));
    else
      for(const int root : roots())
        add_node(root, Transform(CGAL::IDENTITY));
    if(soup_.faces.empty())
      fail("its scene has no triangles");
    check_corners(file_.name(), soup_);
    soup_.facts.unit = Unit::METER;
    soup_.facts.is_parted_at_seams = true;
    for(const auto& [words, is_there] :
        {std::pair("normals", has_normals_), std::pair("texture coordinates", has_texture_),
         std::pair("vertex colors", has_colours_),
         std::pair("materials", !model_.materials.empty()),
         std::pair("skins", !model_.skins.empty()),
         std::pair("animations", !model_.animations.empty())})
      if(is_there)
        soup_.facts.unread.emplace_back(words);
    return std::move(soup_);
  }

private:
  /// Numbers of points, one after the other.
  struct Points
  {
    std::size_t first = 0, count = 0;
  };

  [[noreturn]] void fail(const std::string& problem) const { fail_to_read(file_.name(), problem); }

  void load() {
    const std::string_view content = file_.content();
    if(content.size() > (std::numeric_limits<unsigned>::max)())
      fail("a glTF file cannot be larger than 4 GB");
    const auto size = static_cast<unsigned>(content.size());
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(skip_image, nullptr);
    std::string folder = name_of_path(path_of(file_.path()).parent_path());
    reader.SetFsCallbacks({is_buffer_there, same_path, read_buffer, nullptr, &folder});
    std::string error, warning;
    const bool is_binary = content.substr(0, 4) == "glTF";
    const bool is_read =
        is_binary
            ? reader.LoadBinaryFromMemory(&model_, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(content.data()),
                                          size, folder)
            : reader.LoadASCIIFromString(&model_, &error, &warning, content.data(), size, folder);
    // The text is behind the headers of the file and of the chunk.
    const std::size_t begin = is_binary ? (std::min)(content.size(), std::size_t(20)) : 0;
    if(!is_read)
      fail("it is not a valid glTF 2.0 file: " +
           words_of_json_error(first_line(error), content.substr(begin)));
  }

  static std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? "it cannot be parsed" : line;
  }

  // Those that change no triangle do no harm.
  void check_extensions() const {
    static constexpr const char* harmless[] = {
        "KHR_materials", "KHR_texture",           "EXT_texture",   "MSFT_texture",
        "KHR_lights",    "KHR_mesh_quantization", "KHR_animation", "KHR_xmp"};
    for(const std::string& name : model_.extensionsRequired)
      if(std::none_of(std::begin(harmless), std::end(harmless), [&name](const char* begin) {
           return boost::algorithm::starts_with(name, begin);
         }))
        fail_at_extension(name);
  }

  [[noreturn]] void fail_at_extension(const std::string& name) const {
    const bool is_compression = boost::algorithm::contains(name, "compression");
    fail("it requires the extension " + in_quotes(name) + ", which is not supported" +
         (is_compression ? ": save it without compression" : ""));
  }

  template <typename Extensions> void check_not_compressed(const Extensions& extensions) const {
    for(const auto& [name, value] : extensions)
      if(boost::algorithm::contains(name, "compression") || name == "EXT_mesh_gpu_instancing")
        fail_at_extension(name);
  }

  // Of the scene, or, without one, the nodes that are in no other one.
  std::vector<int> roots() const {
    if(!model_.scenes.empty()) {
      const auto scene = static_cast<std::size_t>((std::max)(model_.defaultScene, 0));
      if(scene >= model_.scenes.size())
        fail("its scene does not exist");
      return model_.scenes[scene].nodes;
    }
    std::set<int> all;
    for(std::size_t node = 0; node < model_.nodes.size(); ++node)
      all.insert(static_cast<int>(node));
    for(const tinygltf::Node& node : model_.nodes)
      for(const int child : node.children)
        all.erase(child);
    return {all.begin(), all.end()};
  }

  template <typename Elements>
  auto& element(Elements& elements, int number, const char* what) const {
    if(number < 0 || static_cast<std::size_t>(number) >= elements.size())
      fail("it refers to a nonexistent " + std::string(what));
    return elements[static_cast<std::size_t>(number)];
  }

  // Nodes make trees: none is within two others, nor within itself.
  void add_node(int root, const Transform& of_root) {
    std::vector<std::pair<int, Transform>> waiting = {{root, of_root}};
    while(!waiting.empty()) {
      const auto [number, above] = waiting.back();
      waiting.pop_back();
      const tinygltf::Node& node = element(model_.nodes, number, "node");
      if(!visited_.insert(number).second)
        fail("its nodes do not form a tree");
      check_not_compressed(node.extensions);
      const Transform transform = above * transform_of(node);
      if(node.mesh >= 0)
        add_mesh(node.mesh, transform);
      for(auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        waiting.emplace_back(*child, transform);
    }
  }

  void add_mesh(int number, const Transform& transform) {
    points_of_.clear();
    for(const tinygltf::Primitive& primitive : element(model_.meshes, number, "mesh").primitives) {
      check_not_compressed(primitive.extensions);
      const auto positions = primitive.attributes.find("POSITION");
      const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
      if(positions == primitive.attributes.end() || mode < TINYGLTF_MODE_TRIANGLES)
        continue; // points or lines
      if(mode > TINYGLTF_MODE_TRIANGLE_FAN)
        fail("a primitive has the unknown mode " + std::to_string(mode));
      note_attributes(primitive);
      add_triangles(mode, points_of(positions->second, transform), primitive, transform.is_odd());
      check_size(file_.name(), soup_);
    }
  }

  void note_attributes(const tinygltf::Primitive& primitive) {
    for(const auto& [name, accessor] : primitive.attributes) {
      has_normals_ = has_normals_ || name == "NORMAL";
      has_texture_ = has_texture_ || boost::algorithm::starts_with(name, "TEXCOORD");
      has_colours_ = has_colours_ || boost::algorithm::starts_with(name, "COLOR");
    }
  }

  Points points_of(int accessor, const Transform& transform) {
    if(const auto known = points_of_.find(accessor); known != points_of_.end())
      return known->second;
    const std::vector<double> x = numbers_of(accessor, 3);
    const Points points = {soup_.points.size(), x.size() / 3};
    for(std::size_t i = 0; i + 2 < x.size(); i += 3)
      soup_.points.push_back(transform(Point(x[i], x[i + 1], x[i + 2])));
    points_of_[accessor] = points;
    return points;
  }

  void add_triangles(int mode,
                     const Points& points,
                     const tinygltf::Primitive& primitive,
                     bool is_mirrored) {
    std::vector<double> corners;
    if(primitive.indices >= 0)
      corners = numbers_of(primitive.indices, 1);
    else {
      corners.resize(points.count);
      std::iota(corners.begin(), corners.end(), 0.);
    }
    const auto vertex = [&](std::size_t i) {
      if(!(corners[i] >= 0. && corners[i] < static_cast<double>(points.count)))
        fail(name_of_face(soup_.faces.size()) + " uses a vertex that does not exist: there are " +
             std::to_string(points.count) + ", numbered from 0");
      return points.first + static_cast<std::size_t>(corners[i]);
    };
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for(std::size_t i = 0; i + 2 < corners.size(); i += step) {
      // As the format numbers the corners of strips and fans.
      const std::size_t odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP ? i % 2 : 0;
      std::array<std::size_t, 3> face = {vertex(i), vertex(i + 1 + odd), vertex(i + 2 - odd)};
      if(mode == TINYGLTF_MODE_TRIANGLE_FAN)
        face = {vertex(i + 1), vertex(i + 2), vertex(0)};
      const bool is_none = face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
      if(is_none && step == 1)
        continue; // joins two strips
      if(is_mirrored)
        std::swap(face[1], face[2]);
      soup_.add_face(face);
    }
  }

  /// Where numbers stand in a buffer, row by row, and of what type they are.
  struct Rows
  {
    int view;
    std::size_t offset, count;
    int type, width;
    bool is_normalized;
  };

  // So many in each row. Without a view they are zeros; a sparse accessor has others in some rows.
  std::vector<double> numbers_of(int number, int width) const {
    const tinygltf::Accessor& accessor = element(model_.accessors, number, "accessor");
    if(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != width)
      fail("an accessor has the wrong type");
    const Rows rows = {
        accessor.bufferView, accessor.byteOffset, accessor.count, accessor.componentType, width,
        accessor.normalized};
    std::vector<double> numbers = rows.view < 0 ? zeros(rows) : read_rows(rows);
    if(accessor.sparse.isSparse)
      replace_rows(numbers, rows, accessor);
    return numbers;
  }

  // Few bytes may say that there are many.
  std::vector<double> zeros(const Rows& rows) const {
    const std::size_t row = sizeof(double) * static_cast<std::size_t>(rows.width);
    constexpr auto largest = (std::numeric_limits<std::size_t>::max)();
    check_room(file_.name(), rows.count > largest / row ? largest : rows.count * row);
    return std::vector<double>(rows.count * static_cast<std::size_t>(rows.width), 0.);
  }

  void replace_rows(std::vector<double>& numbers,
                    const Rows& rows,
                    const tinygltf::Accessor& accessor) const {
    const auto& [count, is_sparse, indices, values] = accessor.sparse;
    if(count < 0 || indices.byteOffset < 0 || values.byteOffset < 0 ||
       static_cast<std::size_t>(count) > rows.count)
      fail("a sparse accessor replaces more rows than exist");
    const auto part = [count = static_cast<std::size_t>(count)](const auto& where, int type,
                                                                int width, bool is_normalized) {
      return Rows{where.bufferView, static_cast<std::size_t>(where.byteOffset), count, type, width,
                  is_normalized};
    };
    const std::vector<double> replaced = read_rows(part(indices, indices.componentType, 1, false));
    const std::vector<double> by =
        read_rows(part(values, rows.type, rows.width, rows.is_normalized));
    const auto width = static_cast<std::size_t>(rows.width);
    for(std::size_t i = 0; i < replaced.size(); ++i) {
      if(!(replaced[i] >= 0. && replaced[i] < static_cast<double>(rows.count)))
        fail("a sparse accessor replaces a row that does not exist");
      std::copy_n(&by[i * width], width, &numbers[static_cast<std::size_t>(replaced[i]) * width]);
    }
  }

  std::vector<double> read_rows(const Rows& rows) const {
    const tinygltf::BufferView& view = element(model_.bufferViews, rows.view, "view");
    check_not_compressed(view.extensions);
    const std::vector<unsigned char>& bytes = element(model_.buffers, view.buffer, "buffer").data;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(rows.type));
    if(size <= 0)
      fail("an accessor has an unknown component type");
    const auto row = static_cast<std::size_t>(size * rows.width);
    const std::size_t stride = view.byteStride == 0 ? row : view.byteStride;
    if(stride < row)
      fail("the rows of an accessor overlap");
    if(view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset ||
       rows.offset > view.byteLength ||
       (rows.count > 0 && (view.byteLength - rows.offset < row ||
                           (view.byteLength - rows.offset - row) / stride < rows.count - 1)))
      fail("an accessor extends beyond its buffer");
    std::vector<double> numbers;
    numbers.reserve(rows.count * static_cast<std::size_t>(rows.width));
    const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for(std::size_t i = 0; i < rows.count; ++i) {
      Binary_source source(file_.name(), all, view.byteOffset + rows.offset + i * stride, true);
      for(int column = 0; column < rows.width; ++column)
        numbers.push_back(read_number(source, rows));
    }
    return numbers;
  }

  // A normalized integer is a share of the largest one.
  double read_number(Binary_source& source, const Rows& rows) const {
    double x = 0., largest = 1.;
    switch(rows.type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      read_as<std::int8_t>(source, x);
      largest = 127.;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      read_as<std::uint8_t>(source, x);
      largest = 255.;
      break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      read_as<std::int16_t>(source, x);
      largest = 32767.;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      read_as<std::uint16_t>(source, x);
      largest = 65535.;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      read_as<std::uint32_t>(source, x);
      break;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      read_as<float>(source, x);
      break;
    default:
      fail("an accessor has an unknown component type");
    }
    return rows.is_normalized ? (std::max)(x / largest, -1.) : x;
  }

  const Input_file& file_;
  tinygltf::Model model_;
  Soup soup_;
  std::set<int> visited_;
  std::map<int, Points> points_of_; // by accessor, of this mesh: primitives may share them
  bool has_normals_ = false, has_texture_ = false, has_colours_ = false;
};

} // namespace

Soup read_gltf(const Input_file& file) { return Gltf_reader(file).read(); }

} // namespace htloops
