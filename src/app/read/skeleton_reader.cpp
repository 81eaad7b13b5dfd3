// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/skeleton_reader.h"

#include "read/Vtk_document.h"
#include "read/json_node.h"
#include "read/meshes/formats.h"
#include "read/sources.h"
#include "read/xml.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace htloops {
namespace {

// Collects points and lines, and leaves out what no line uses.
class Line_collector
{
public:
  /// Points at the same place are one if `are_merged`.
  explicit Line_collector(const Input_file& file, bool are_merged = false)
      : file_(file)
      , are_merged_(are_merged) {}

  std::size_t add_point(const Point& p, const std::string& name) {
    if(!is_finite(p))
      fail_to_read(file_.name(), "point " + name + " is not finite");
    const std::size_t number = numbers_.size();
    const auto place = std::make_pair(std::array<double, 3>{p.x(), p.y(), p.z()}, number);
    numbers_.push_back(are_merged_ ? places_.insert(place).first->second : number);
    lines_.points.push_back(p);
    lines_.names.push_back(name);
    is_used_.push_back(0);
    return number;
  }

  std::size_t number_of_points() const { return numbers_.size(); }

  void set_component(std::size_t point, std::size_t component) {
    lines_.components.resize(is_used_.size());
    lines_.components[numbers_[point]] = component;
  }

  void set_inlet(std::size_t point, bool is_inlet) {
    lines_.is_inlet.resize(is_used_.size());
    lines_.is_inlet[numbers_[point]] = is_inlet;
  }

  /// a point that is there without a line, too.
  void use(std::size_t point) { is_used_[checked(point)] = 1; }

  void add_edge(std::size_t p, std::size_t q) {
    use(p);
    use(q);
    if(!are_merged_ || numbers_[p] != numbers_[q])
      lines_.edges.push_back({numbers_[p], numbers_[q]});
  }

  void add_line(const std::vector<std::size_t>& points) {
    if(points.size() == 1)
      use(points.front());
    for(std::size_t i = 1; i < points.size(); ++i)
      add_edge(points[i - 1], points[i]);
  }

  /// \p may_be_empty if something else says that it is about a skeleton.
  Skeleton_lines finish(bool may_be_empty = false) {
    Skeleton_lines used;
    std::vector<std::size_t> number(is_used_.size());
    if(!lines_.components.empty())
      lines_.components.resize(number.size());
    if(!lines_.is_inlet.empty())
      lines_.is_inlet.resize(number.size());
    for(std::size_t i = 0; i < number.size(); ++i)
      if(is_used_[i] != 0) {
        number[i] = used.points.size();
        used.points.push_back(lines_.points[i]);
        used.names.push_back(lines_.names[i]);
        if(!lines_.components.empty())
          used.components.push_back(lines_.components[i]);
        if(!lines_.is_inlet.empty())
          used.is_inlet.push_back(lines_.is_inlet[i]);
      }
    if(used.points.empty() && !may_be_empty)
      fail_to_read(file_.name(), "it has no lines");
    for(const auto& [p, q] : lines_.edges)
      used.edges.push_back({number[p], number[q]});
    return used;
  }

private:
  std::size_t checked(std::size_t point) const {
    if(point >= numbers_.size())
      fail_to_read(file_.name(), "a line passes through a point that does not exist");
    return numbers_[point];
  }

  const Input_file& file_;
  bool are_merged_;
  Skeleton_lines lines_;
  std::vector<std::size_t> numbers_; // by point as it was added, the first at its place
  std::vector<char> is_used_;
  std::map<std::array<double, 3>, std::size_t> places_;
};

// ---- JSON

constexpr char json_format[] = "htloops-skeleton/1";

// Nodes, and then the points within arcs, in their order.
class Json_reader
{
public:
  explicit Json_reader(const Input_file& file)
      : lines_(file) {}

  Skeleton_record read(const Json_node& document) {
    document.require_format(json_format, "'htloops skeleton MESH -o FILE.json' writes skeletons");
    document.member("nodes").for_each("node", [&](const Json_node& node) { add_node(node); });
    document.member("arcs").for_each("arc", [&](const Json_node& arc) { add_arc(arc); });
    Skeleton_record record = {lines_.finish(true), {}};
    if(document.has("mesh")) {
      const Json_node mesh = document.member("mesh");
      record.mesh_size = {mesh.member("vertices").count(), mesh.member("faces").count()};
    }
    return record;
  }

private:
  std::size_t add_point(const Point& p) {
    return lines_.add_point(p, std::to_string(lines_.number_of_points()));
  }

  static Point point_of(const Json_node& node) {
    const auto [x, y, z] = node.point();
    return Point(x, y, z);
  }

  void add_node(const Json_node& node) {
    if(node.member("id").count() != nodes_.size())
      node.fail("has an id that is not its position");
    nodes_.push_back(point_of(node.member("position")));
    const std::size_t p = add_point(nodes_.back());
    lines_.use(p);
    lines_.set_inlet(p, node.member("kind").is("inlet"));
    if(node.has("component")) // those of arcs tell it, too
      lines_.set_component(p, node.member("component").count());
  }

  std::size_t end_of(const Json_node& arc, const char* name, const Point& place) const {
    const std::size_t node = arc.member(name).count();
    if(node >= nodes_.size())
      arc.member(name).fail("is not a node");
    if(nodes_[node] != place)
      arc.fail("has a polyline that does not reach its " + std::string(name));
    return node;
  }

  void add_arc(const Json_node& arc) {
    std::vector<Point> polyline;
    arc.member("polyline").for_each("point", [&](const Json_node& point) {
      polyline.push_back(point_of(point));
    });
    if(polyline.size() < 2)
      arc.fail("has a polyline of fewer than two points");
    std::vector<std::size_t> points = {end_of(arc, "source", polyline.front())};
    for(std::size_t i = 1; i + 1 < polyline.size(); ++i)
      points.push_back(add_point(polyline[i]));
    points.push_back(end_of(arc, "target", polyline.back()));
    lines_.add_line(points);
    const std::size_t component = arc.member("component").count();
    for(const std::size_t p : points)
      lines_.set_component(p, component);
  }

  Line_collector lines_;
  std::vector<Point> nodes_; // by id
};

Skeleton_record read_skeleton_json(const Input_file& file) {
  return read_json(file,
                   [&](const Json_node& document) { return Json_reader(file).read(document); });
}

// ---- lines of text

double coordinate(Text_source& text) {
  double x;
  if(!text.read(x))
    text.fail("a point does not have three coordinates");
  return x;
}

Point read_point(Text_source& text) {
  const double x = coordinate(text), y = coordinate(text), z = coordinate(text);
  return Point(x, y, z);
}

// A point of a line, "3", "-1" or "3/7", of so many.
std::size_t obj_index(Text_source& text, std::size_t n) {
  const std::string word(text.word());
  char* end = nullptr;
  const long long i = std::strtoll(word.c_str(), &end, 10), size = static_cast<long long>(n);
  if(end == word.c_str() || i == 0 || i > size || i < -size)
    text.fail(in_quotes(word) + " is not one of the " + std::to_string(n) + " points so far");
  return static_cast<std::size_t>(i > 0 ? i - 1 : size + i);
}

Skeleton_record read_skeleton_obj(const Input_file& file) {
  Line_collector lines(file, true);
  const std::string content = join_continued_lines(std::string(file.content()));
  Text_source text(file.name(), content);
  for(; text.skip_to_content(); text.skip_line()) {
    const std::string_view what = text.word();
    if(what == "v")
      lines.add_point(read_point(text), std::to_string(lines.number_of_points() + 1));
    else if(what == "l" || what == "p") {
      std::vector<std::size_t> points;
      while(!text.is_at_line_end())
        points.push_back(obj_index(text, lines.number_of_points()));
      if(what == "l")
        lines.add_line(points);
      else
        for(const std::size_t p : points)
          lines.use(p);
    }
  }
  return {lines.finish(), {}};
}

// id, type, x, y, z, radius, id of the parent or -1. A cycle is cut where a point is there twice.
Skeleton_record read_swc(const Input_file& file) {
  Line_collector lines(file, true);
  Text_source text(file.name(), file.content());
  std::map<long long, std::size_t> number;
  std::vector<long long> parents;
  for(; text.skip_to_content(); text.skip_line()) {
    long long id = 0, type = 0, parent = 0;
    if(!text.read(id) || !text.read(type))
      text.fail("a line does not begin with the number and the type of a point");
    const Point point = read_point(text);
    double radius;
    if(!text.read(radius) || !text.read(parent))
      text.fail("a point has no radius or no parent");
    const std::size_t n = lines.add_point(point, std::to_string(id));
    if(!number.emplace(id, n).second)
      text.fail("the number " + std::to_string(id) + " appears twice");
    lines.use(n);
    parents.push_back(parent);
  }
  for(std::size_t i = 0; i < parents.size(); ++i)
    if(parents[i] >= 0) {
      const auto parent = number.find(parents[i]);
      if(parent == number.end())
        fail_to_read(file.name(),
                     "the parent " + std::to_string(parents[i]) + " of a point does not exist");
      lines.add_edge(parent->second, i);
    }
  return {lines.finish(), {}};
}

// Of CGAL: on each line, how many points, and their coordinates.
Skeleton_record read_polylines(const Input_file& file) {
  Line_collector lines(file, true);
  Text_source text(file.name(), file.content());
  for(std::size_t line = 1; text.skip_to_content(); ++line) {
    long long n = 0;
    if(!text.read(n) || n < 1)
      text.fail("a line does not begin with the number of its points");
    std::vector<std::size_t> points;
    for(long long i = 1; i <= n; ++i)
      points.push_back(lines.add_point(read_point(text), "(line " + std::to_string(line) +
                                                             ", point " + std::to_string(i) + ")"));
    lines.add_line(points);
    if(!text.is_at_line_end())
      text.fail("a line has more numbers than its points need");
  }
  return {lines.finish(), {}};
}

// ---- XML

class Vtp_reader
{
public:
  explicit Vtp_reader(const Input_file& file)
      : file_(file)
      , document_(file)
      , lines_(file, true) {}

  Skeleton_record read() {
    const Xml_tree* poly_data = document_.data_set("PolyData");
    if(poly_data == nullptr)
      fail_to_read(file_.name(), "it is not VTK PolyData");
    Vtk_document::for_each_piece(*poly_data, [this](const Xml_tree& piece) { read_piece(piece); });
    return {lines_.finish(), {}};
  }

private:
  void read_piece(const Xml_tree& piece) {
    const auto array = [&](const char* section, const char* name) {
      return document_.array(piece, section, name);
    };
    const Vtk_document::Numbers points = document_.points(piece),
                                inlets = array("PointData", "Inlet"),
                                components = array("CellData", "Component");
    const std::size_t first = lines_.number_of_points(), n = points.size() / 3;
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t p = lines_.add_point(
          Point(points[3 * i], points[3 * i + 1], points[3 * i + 2]), std::to_string(first + i));
      if(inlets.size() == n)
        lines_.set_inlet(p, inlets[i] != 0.);
    }
    Vtk_document::Cells all = document_.cells(piece, "Verts", first, n),
                        more = document_.cells(piece, "Lines", first, n);
    all.insert(all.end(), more.begin(), more.end());
    for(std::size_t c = 0; c < all.size(); ++c) {
      lines_.add_line(all[c]);
      if(c < components.size())
        for(const std::size_t p : all[c])
          lines_.set_component(p, component(components[c]));
    }
  }

  std::size_t component(double number) const {
    if(!(number >= 0. && number < 1e15))
      fail_to_read(file_.name(), "a line has a component that is not a non-negative integer");
    return static_cast<std::size_t>(number);
  }

  const Input_file& file_;
  Vtk_document document_;
  Line_collector lines_;
};

class Graphml_reader
{
public:
  explicit Graphml_reader(const Input_file& file)
      : file_(file)
      , lines_(file) {}

  Skeleton_record read() {
    const Xml_tree tree = read_xml(file_);
    const auto root = tree.get_child_optional("graphml");
    const auto graph = tree.get_child_optional("graphml.graph");
    if(!root || !graph)
      fail_to_read(file_.name(), "it is not GraphML");
    for(const auto& [kind, key] : *root)
      if(kind == "key")
        name_of_key_[xml_attribute(key, "id")] = xml_attribute(key, "attr.name");
    for(const auto& [kind, node] : *graph)
      if(kind == "node")
        add_node(node);
    for(const auto& [kind, edge] : *graph)
      if(kind == "edge") {
        const std::size_t from = number_of(xml_attribute(edge, "source"));
        lines_.add_edge(from, number_of(xml_attribute(edge, "target")));
      }
    return {lines_.finish(), {}};
  }

private:
  void add_node(const Xml_tree& node) {
    std::map<std::string, std::string> data;
    for(const auto& [kind, value] : node)
      if(kind == "data") {
        const auto name = name_of_key_.find(xml_attribute(value, "key"));
        data[name == name_of_key_.end() ? xml_attribute(value, "key") : name->second] =
            value.data();
      }
    const std::string id = xml_attribute(node, "id");
    const auto number = [&](const char* name) {
      const std::vector<double> all = numbers_of_text(file_, data[name]);
      if(all.size() != 1)
        fail_to_read(file_.name(), "node " + id + " has no " + name);
      return all.front();
    };
    const double x = number("x"), y = number("y"), z = number("z");
    const std::size_t n = lines_.add_point(Point(x, y, z), id);
    lines_.use(n);
    if(!number_of_.emplace(id, n).second)
      fail_to_read(file_.name(), "node " + id + " appears twice");
    if(data.count("component") != 0)
      lines_.set_component(n, static_cast<std::size_t>(number("component")));
    if(data.count("inlet") != 0)
      lines_.set_inlet(n, data["inlet"] == "true" || data["inlet"] == "1");
  }

  std::size_t number_of(const std::string& id) const {
    const auto it = number_of_.find(id);
    if(it == number_of_.end())
      fail_to_read(file_.name(), "an edge refers to node " + id + ", which does not exist");
    return it->second;
  }

  const Input_file& file_;
  Line_collector lines_;
  std::map<std::string, std::string> name_of_key_; // by id
  std::map<std::string, std::size_t> number_of_;   // of a node, by id
};

Skeleton_record read_vtp(const Input_file& file) { return Vtp_reader(file).read(); }
Skeleton_record read_graphml(const Input_file& file) { return Graphml_reader(file).read(); }

struct Format
{
  const char* ending;
  Skeleton_record (*read)(const Input_file&);
};

constexpr Format formats[] = {
    {".obj", read_skeleton_obj}, {".vtp", read_vtp},        {".swc", read_swc},
    {".graphml", read_graphml},  {".cgal", read_polylines}, {".polylines.txt", read_polylines},
};

} // namespace

bool is_skeleton_file(const Input_file& file) {
  for(const Format& format : formats)
    if(file.is_of_format(format.ending))
      return true;
  return file.content().find("\"" + std::string(json_format) + "\"") != std::string_view::npos;
}

std::string endings_of_skeletons() {
  std::string all;
  for(const Format& format : formats)
    all += (all.empty() ? "" : " ") + std::string(format.ending);
  return all;
}

Skeleton_record read_skeleton(const Input_file& file) {
  for(const Format& format : formats)
    if(file.is_of_format(format.ending))
      return format.read(file);
  return read_skeleton_json(file);
}

} // namespace htloops
