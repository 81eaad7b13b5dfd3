// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "check/document_comparison.h"

#include "words.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace htloops {
namespace {

/// How the values of a key are compared. In numbers, powers of lengths round differently.
enum class Rule {
  RATIO,
  LENGTH,
  AREA,
  VOLUME,
  IF_KNOWN,
  SOME_MEMBERS,
  ELSEWHERE,
  IS_THERE, // which it is, is not compared
  NOT_COMPARED
};

struct Key
{
  const char* name;
  Rule rule;
  const char* reason = "";
};

// Why something is not compared.
constexpr char of_history[] = "how the file came about",
               name_of_mesh_file[] = "the name of the mesh", one_of_many[] = "a choice among many",
               not_in_mesh_file[] = "not in the file of the mesh",
               not_known_here[] = "unknown to this version";

// All keys of documents of loops and of skeletons, but for those within options and timings. Of
// words, counts and truths any rule that compares says that they are equal.
constexpr Key keys[] = {
    {"across_faces", Rule::IF_KNOWN},
    {"arc", Rule::RATIO},
    {"arcs", Rule::RATIO},
    {"area", Rule::AREA},
    {"axis", Rule::RATIO},
    {"backend", Rule::NOT_COMPARED, of_history},
    {"balls", Rule::NOT_COMPARED, of_history},
    {"basis", Rule::RATIO},
    {"bore", Rule::RATIO},
    {"boundaries", Rule::RATIO},
    {"bounds", Rule::RATIO},
    {"bounds_alone", Rule::RATIO},
    {"box", Rule::LENGTH},
    {"centre", Rule::LENGTH},
    {"certificate", Rule::RATIO},
    {"circle", Rule::RATIO},
    {"clear_width", Rule::RATIO},
    {"closed_on_surface", Rule::RATIO},
    {"component", Rule::RATIO},
    {"components", Rule::RATIO},
    {"connected", Rule::RATIO},
    {"curve", Rule::LENGTH},
    {"cut", Rule::RATIO},
    {"cycles", Rule::RATIO},
    {"depth", Rule::LENGTH},
    {"deviation", Rule::LENGTH},
    {"diameter", Rule::LENGTH},
    {"diameter_of", Rule::RATIO},
    {"drilling", Rule::RATIO},
    {"edges_outside", Rule::RATIO},
    {"embedded", Rule::RATIO},
    {"ended_by_time", Rule::NOT_COMPARED, of_history},
    {"error", Rule::LENGTH},
    {"faces", Rule::RATIO},
    {"failure", Rule::RATIO},
    {"fallback", Rule::NOT_COMPARED, of_history},
    {"file", Rule::NOT_COMPARED, name_of_mesh_file},
    {"fill", Rule::RATIO},
    {"format", Rule::RATIO},
    {"genus", Rule::RATIO},
    {"handle", Rule::RATIO},
    {"handles_bound_inside", Rule::IF_KNOWN},
    {"handles_bound_inside_alone", Rule::IF_KNOWN},
    {"id", Rule::RATIO},
    {"inside", Rule::RATIO},
    {"kind", Rule::RATIO},
    {"length", Rule::LENGTH},
    {"linking", Rule::ELSEWHERE}, // in any order
    {"locations", Rule::RATIO},
    {"mean_radius", Rule::LENGTH},
    {"mesh", Rule::RATIO},
    {"no_cut_because", Rule::RATIO},
    {"no_fill_because", Rule::RATIO},
    {"nodes", Rule::RATIO},
    {"normal", Rule::RATIO},
    {"not_measured_because", Rule::RATIO},
    {"on_cycle", Rule::RATIO},
    {"options", Rule::SOME_MEMBERS, of_history},
    {"out_of_roundness", Rule::RATIO},
    {"pair", Rule::RATIO},
    {"pairing", Rule::RATIO},
    {"pairs", Rule::RATIO},
    {"points", Rule::LENGTH},
    {"polyline", Rule::LENGTH},
    {"position", Rule::LENGTH},
    {"prominence", Rule::NOT_COMPARED, "an estimate"},
    {"radii", Rule::LENGTH},
    {"radius", Rule::LENGTH},
    {"separating", Rule::RATIO},
    {"shape", Rule::RATIO},
    {"size", Rule::RATIO},
    {"smallest_radius", Rule::LENGTH},
    {"source", Rule::RATIO},
    {"taken_alone", Rule::RATIO},
    {"target", Rule::RATIO},
    {"thickness", Rule::RATIO},
    {"threads", Rule::NOT_COMPARED, of_history},
    {"throat", Rule::LENGTH},
    {"throats", Rule::RATIO},
    {"through", Rule::NOT_COMPARED, of_history},
    {"timings", Rule::NOT_COMPARED, of_history},
    {"tool", Rule::NOT_COMPARED, of_history},
    {"tortuosity", Rule::RATIO},
    {"tunnel", Rule::RATIO},
    {"tunnels_bound_outside", Rule::IF_KNOWN},
    {"tunnels_bound_outside_alone", Rule::IF_KNOWN},
    {"types", Rule::RATIO},
    {"undecided_because", Rule::IS_THERE, one_of_many},
    {"unit", Rule::IF_KNOWN},
    {"vertex_point", Rule::NOT_COMPARED, one_of_many},
    {"vertices", Rule::RATIO},
    {"volume", Rule::VOLUME},
    {"waist", Rule::RATIO},
    {"wall_diameter", Rule::LENGTH},
};

const Key* find_key(const std::string& name) {
  const auto found =
      std::find_if(std::begin(keys), std::end(keys), [&](const Key& k) { return k.name == name; });
  return found == std::end(keys) ? nullptr : &*found;
}

// On one line, and printable.
std::string in_words(const Json& value) {
  if(value.is_number_float())
    return htloops::in_words(value.get<double>());
  const std::string text = text_of(value);
  constexpr std::size_t most = 80;
  if(value.is_structured() && text.size() > most)
    return text.substr(0, most) + "...";
  return value.is_string() ? text.substr(1, text.size() - 2) : text;
}

class Document_comparison
{
public:
  explicit Document_comparison(double largest_coordinate)
      : largest_(largest_coordinate) {}

  void compare_members(const std::string& place, const Json& given, const Json& is) {
    for(const auto& [name, value] : given.items()) {
      const Key* key = find_key(name);
      if(key == nullptr)
        leave_out(not_known_here, name);
      else if(key->rule == Rule::NOT_COMPARED)
        leave_out(key->reason, name);
      else if(key->rule == Rule::ELSEWHERE)
        continue;
      else if(is.contains(name) && key->rule == Rule::IS_THERE)
        leave_out(key->reason, name);
      else if(is.contains(name))
        compare(place, *key, value, is[name]);
      else if(key->rule == Rule::IF_KNOWN)
        leave_out(not_in_mesh_file, name);
      else
        add(place, name + " is given as " + in_words(value) + ", but there is none");
    }
  }

  Document_differences result() { return std::move(result_); }

private:
  void leave_out(const char* reason, const std::string& key) {
    result_.not_compared[reason].insert(key);
  }

  void add(const std::string& place, const std::string& claim) {
    result_.claims.push_back((place.empty() ? "" : place + ": ") + claim);
  }

  void compare(const std::string& place, const Key& key, const Json& given, const Json& is) {
    const std::string before = place.empty() ? "" : place + ", ";
    if(key.rule == Rule::IF_KNOWN && given.is_null())
      return;
    if(key.rule == Rule::SOME_MEMBERS && given.is_object()) {
      for(const auto& [name, value] : given.items())
        if(is.contains(name))
          compare(before + key.name, {name.c_str(), Rule::RATIO}, value, is[name]);
        else
          leave_out(key.reason, key.name);
    } else if(given.is_object() && is.is_object())
      compare_members(before + key.name, given, is);
    else if(given.is_array() && is.is_array() && given.size() == is.size() && has_parts(is))
      compare_elements(before, key, place, given, is);
    else if(!are_same(key.rule, given, is))
      add(place, given_as(key.name, in_words(given), in_words(is)));
  }

  static bool has_parts(const Json& array) {
    return array.size() > 3 || (!array.empty() && array[0].is_structured());
  }

  // Of objects each, of numbers and points the first that differs.
  void compare_elements(const std::string& before,
                        const Key& key,
                        const std::string& place,
                        const Json& given,
                        const Json& is) {
    const std::string name = key.name;
    for(std::size_t i = 0; i < is.size(); ++i)
      if(given[i].is_object() && is[i].is_object())
        compare_members(before + one_of(name) + " " + std::to_string(i), given[i], is[i]);
      else if(!are_same(key.rule, given[i], is[i]))
        return add(place,
                   given_as(name + " " + std::to_string(i), in_words(given[i]), in_words(is[i])));
  }

  static std::string one_of(const std::string& many) {
    const std::size_t end = many.size() - 1;
    return many == "boundaries" ? "boundary" : many[end] == 's' ? many.substr(0, end) : many;
  }

  bool are_same(Rule rule, const Json& given, const Json& is) const {
    if(is.is_number_float() && given.is_number())
      return are_about_equal(rule, given.get<double>(), is.get<double>());
    if(is.is_number_float() && given.is_null()) // JSON has no infinity
      return !std::isfinite(is.get<double>());
    if(is.is_array() && given.is_array() && is.size() == given.size()) {
      for(std::size_t i = 0; i < is.size(); ++i)
        if(!are_same(rule, given[i], is[i]))
          return false;
      return true;
    }
    return given == is;
  }

  bool are_about_equal(Rule rule, double a, double b) const {
    constexpr double rounding = 1e-9;
    const double unit = rule == Rule::LENGTH   ? largest_
                        : rule == Rule::AREA   ? largest_ * largest_
                        : rule == Rule::VOLUME ? largest_ * largest_ * largest_
                                               : 1.;
    // Halves, as the difference may be beyond all doubles.
    const double most = rounding * (std::abs(a / 2.) + std::abs(b / 2.));
    return a == b ||
           std::abs(a / 2. - b / 2.) <= most + (std::isfinite(unit) ? rounding * (unit / 2.) : 0.);
  }

  double largest_;
  Document_differences result_;
};

} // namespace

const char* why_not_compared(const std::string& key) {
  const Key* found = find_key(key);
  return found == nullptr ? nullptr : found->reason;
}

std::string given_as(const std::string& what, const std::string& given, const std::string& is) {
  return what + " is given as " + given + ", but is " + is;
}

Document_differences
compare_documents(const Json& given, const Json& is, double largest_coordinate) {
  Document_comparison comparison(largest_coordinate);
  comparison.compare_members("", given, is);
  return comparison.result();
}

} // namespace htloops
