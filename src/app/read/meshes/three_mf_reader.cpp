// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "interrupt.h"
#include "read/Zip_content.h"
#include "read/meshes/readers.h"
#include "read/sources.h"

#include <CGAL/Aff_transformation_3.h>

#include <expat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace htloops {
namespace {

using Transform = CGAL::Aff_transformation_3<Kernel>;

constexpr std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
constexpr char path_of_part[] =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr char resolution_beside_slices[] =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|meshresolution";

// Extensions of which all that bears on triangles is read here: those of production have objects in
// files of their own, slices stand beside meshes, and the others add to triangles.
constexpr std::string_view known_extensions[] = {
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

// Without what all of the consortium have in common.
std::string name_of_extension(std::string_view space) {
  constexpr std::string_view common = "3dmanufacturing/";
  const std::size_t at = space.find(common);
  return in_quotes(at == space.npos ? space : space.substr(at + common.size()));
}

// The attributes of an element, by their names.
class Attributes
{
public:
  explicit Attributes(const char** words)
      : words_(words) {}

  std::string_view operator[](std::string_view name) const {
    for(const char** word = words_; *word != nullptr; word += 2)
      if(*word == name)
        return word[1];
    return {};
  }

private:
  const char** words_;
};

// Calls `visit(name, attributes)` for all elements of a document as they begin.
class Xml_elements
{
public:
  using Visit = std::function<void(std::string_view, const Attributes&)>;

  Xml_elements(const Input_file& file, Visit visit)
      : file_(file)
      , visit_(std::move(visit)) {}

  void read(std::string_view document) {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
        XML_ParserCreateNS(nullptr, '|'), XML_ParserFree);
    parser_ = parser.get();
    XML_SetUserData(parser_, this);
    XML_SetStartElementHandler(parser_, begin_element);
    XML_SetStartNamespaceDeclHandler(parser_, begin_prefix);
    constexpr std::size_t step = std::size_t(1) << 20;
    for(bool is_last = false; !is_last; document.remove_prefix((std::min)(step, document.size()))) {
      throw_if_interrupted();
      const std::string_view part = document.substr(0, step);
      is_last = part.size() == document.size();
      const bool is_read = XML_Parse(parser_, part.data(), static_cast<int>(part.size()), is_last);
      if(failure_)
        std::rethrow_exception(failure_);
      if(!is_read)
        fail_to_read(file_.name(), std::string("its model is not valid XML: ") +
                                       XML_ErrorString(XML_GetErrorCode(parser_)) + " in line " +
                                       std::to_string(XML_GetCurrentLineNumber(parser_)));
    }
  }

  /// what a prefix of names stands for, as it was declared last; empty if it was not.
  std::string_view meaning_of(const std::string& prefix) const {
    const auto found = prefixes_.find(prefix);
    return found == prefixes_.end() ? std::string_view() : found->second;
  }

private:
  static void XMLCALL begin_element(void* self, const char* name, const char** attributes) {
    auto& elements = *static_cast<Xml_elements*>(self);
    elements.note_failure_of([&] { elements.visit_(name, Attributes(attributes)); });
  }

  static void XMLCALL begin_prefix(void* self, const char* prefix, const char* meaning) {
    auto& elements = *static_cast<Xml_elements*>(self);
    elements.note_failure_of([&] {
      if(prefix != nullptr && meaning != nullptr)
        elements.prefixes_[prefix] = meaning;
    });
  }

  // No exception may go through a function of C.
  template <typename Action> void note_failure_of(Action action) {
    try {
      action();
    } catch(...) {
      failure_ = std::current_exception();
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  const Input_file& file_;
  Visit visit_;
  std::map<std::string, std::string> prefixes_;
  XML_Parser parser_ = nullptr;
  std::exception_ptr failure_;
};

// An object is named by the part of the package in which it is, and its number there.
using Name = std::pair<std::string, std::string>;

// Where an object goes.
struct Placed_object
{
  Name name;
  Transform transform;
};

struct Object
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Placed_object> components;
};

std::string without_slash(std::string_view name) {
  name.remove_prefix(name.substr(0, 1) == "/" ? 1 : 0);
  return std::string(name);
}

class Reader_of_3mf
{
public:
  explicit Reader_of_3mf(const Input_file& file)
      : file_(file)
      , package_(file) {}

  Soup read() {
    soup_.facts.unit = Unit::MILLIMETER;
    waiting_ = {name_of_model()};
    for(std::size_t i = 0; i < waiting_.size(); ++i)
      read_part(std::string(waiting_[i]));
    for(const Placed_object& item : items_)
      add(item, 0);
    if(soup_.faces.empty())
      fail_to_read(file_.name(), "its build has no triangles");
    check_corners(file_.name(), soup_);
    return std::move(soup_);
  }

private:
  // What the relations of the package name as its model.
  std::string name_of_model() const {
    std::string name;
    if(package_.has("_rels/.rels"))
      Xml_elements(file_, [&name](std::string_view, const Attributes& attributes) {
        const std::string_view type = attributes["Type"], end = "/3dmodel";
        if(type.size() > end.size() && type.substr(type.size() - end.size()) == end)
          name = without_slash(attributes["Target"]);
      }).read(package_.read("_rels/.rels"));
    return name.empty() ? "3D/3dmodel.model" : name;
  }

  void read_part(const std::string& part) {
    if(!parts_.insert(part).second)
      return;
    Object* object = nullptr;
    const bool is_model = parts_.size() == 1;
    Xml_elements elements(file_, [&](std::string_view name, const Attributes& attributes) {
      if(name.substr(0, core.size()) != core)
        return;
      name.remove_prefix(core.size());
      if(name == "object") {
        check_resolution(attributes);
        object = &objects_[{part, std::string(attributes["id"])}];
      } else if(name == "model") {
        check_extensions(elements, attributes);
        if(is_model)
          read_unit(attributes["unit"]);
      } else if(name == "item" && is_model)
        items_.push_back(placed(part, attributes));
      else if(object != nullptr)
        read_element(part, name, attributes, *object);
    });
    elements.read(package_.read(part));
  }

  // Calls `visit(extension)` for each one that is listed, by prefixes, and not known here.
  template <typename Visit>
  static void
  for_each_unknown(const Xml_elements& elements, std::string_view prefixes, Visit visit) {
    std::istringstream list{std::string(prefixes)};
    for(std::string prefix; list >> prefix;) {
      const std::string_view space = elements.meaning_of(prefix);
      if(std::find(std::begin(known_extensions), std::end(known_extensions), space) ==
         std::end(known_extensions))
        visit(space.empty() ? in_quotes(prefix) : name_of_extension(space));
    }
  }

  void check_extensions(const Xml_elements& elements, const Attributes& attributes) {
    for_each_unknown(elements, attributes["requiredextensions"], [&](const std::string& name) {
      fail_to_read(file_.name(), "it requires the 3MF extension " + name +
                                     ", which is not supported: save it as plain triangles");
    });
    for_each_unknown(elements, attributes["recommendedextensions"], [&](const std::string& name) {
      const std::string words = "data of the 3MF extension " + name;
      std::vector<std::string>& unread = soup_.facts.unread;
      if(std::find(unread.begin(), unread.end(), words) == unread.end())
        unread.push_back(words);
    });
  }

  void check_resolution(const Attributes& attributes) const {
    if(attributes[resolution_beside_slices] == "lowres")
      fail_to_read(file_.name(), "its triangles only approximate slices, which are not supported");
  }

  void read_unit(std::string_view name) {
    if(name.empty())
      return;
    for(const Unit unit :
        {Unit::MICRON, Unit::MILLIMETER, Unit::CENTIMETER, Unit::INCH, Unit::FOOT, Unit::METER})
      if(name == words_of(unit).name) {
        soup_.facts.unit = unit;
        return;
      }
    fail_to_read(file_.name(), "unknown unit " + in_quotes(name));
  }

  void read_element(const std::string& part,
                    std::string_view name,
                    const Attributes& attributes,
                    Object& object) {
    if(name == "vertex")
      object.points.emplace_back(number(attributes["x"]), number(attributes["y"]),
                                 number(attributes["z"]));
    else if(name == "triangle")
      object.triangles.push_back(
          {vertex(attributes["v1"]), vertex(attributes["v2"]), vertex(attributes["v3"])});
    else if(name == "component")
      object.components.push_back(placed(part, attributes));
  }

  double number(std::string_view text) const {
    double x = 0.;
    Text_source source(file_.name(), text);
    if(!source.read(x))
      fail_to_read(file_.name(), "expected a number, not " + in_quotes(text));
    return x;
  }

  std::size_t vertex(std::string_view text) const {
    const double v = number(text);
    return v >= 0. && v < 4e9 && v == std::floor(v) ? static_cast<std::size_t>(v)
                                                    : (std::numeric_limits<std::uint32_t>::max)();
  }

  // A row of the matrix is where an axis goes, the last one where the origin does.
  Placed_object placed(const std::string& part, const Attributes& attributes) {
    const std::string_view path = attributes[path_of_part], text = attributes["transform"];
    Placed_object object = {
        {path.empty() ? part : without_slash(path), std::string(attributes["objectid"])},
        Transform(CGAL::IDENTITY)};
    if(!path.empty()) // objects may be in files of their own within the package
      waiting_.push_back(object.name.first);
    if(text.empty())
      return object;
    Text_source source(file_.name(), text);
    std::array<double, 12> m{};
    for(double& x : m)
      if(!source.read(x))
        fail_to_read(file_.name(), "a transform does not have twelve numbers: " + in_quotes(text));
    if(source.skip_to_content())
      fail_to_read(file_.name(), "a transform has more than twelve numbers: " + in_quotes(text));
    object.transform =
        Transform(m[0], m[3], m[6], m[9], m[1], m[4], m[7], m[10], m[2], m[5], m[8], m[11]);
    return object;
  }

  // Components may hold components, and name an object twice: so a small file may say a lot.
  void add(const Placed_object& placed, int depth) {
    check_size(file_.name(), soup_);
    const auto found = objects_.find(placed.name);
    if(found == objects_.end())
      fail_to_read(file_.name(), "it refers to object " + in_quotes(placed.name.second) +
                                     ", which does not exist");
    constexpr int deepest = 100;
    constexpr std::size_t most_objects = 1000000;
    if(depth > deepest || ++number_of_objects_ > most_objects ||
       3 * soup_.faces.size() > Soup::largest_number_of_halfedges)
      fail_to_read(file_.name(), "its components are too many, or nested too deeply");
    add_mesh(found->second, placed.transform);
    for(const Placed_object& component : found->second.components)
      add({component.name, placed.transform * component.transform}, depth + 1);
  }

  void add_mesh(const Object& object, const Transform& transform) {
    const std::size_t first = soup_.points.size(), n = object.points.size();
    for(const Point& point : object.points)
      soup_.points.push_back(transform(point));
    const bool is_mirrored = transform.is_odd();
    for(const std::array<std::size_t, 3>& triangle : object.triangles) {
      std::array<std::size_t, 3> face{};
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = triangle[is_mirrored ? 2 - i : i];
        if(v >= n)
          fail_to_read(file_.name(),
                       no_such_vertex(soup_.faces.size(), static_cast<long long>(v), n));
        face[i] = first + v;
      }
      soup_.add_face(face);
    }
  }

  const Input_file& file_;
  Zip_content package_;
  std::vector<std::string> waiting_; // parts that are read one after the other
  std::set<std::string> parts_;      // that were read
  std::map<Name, Object> objects_;
  std::vector<Placed_object> items_;
  Soup soup_;
  std::size_t number_of_objects_ = 0;
};

} // namespace

Soup read_3mf(const Input_file& file) { return Reader_of_3mf(file).read(); }

} // namespace htloops
