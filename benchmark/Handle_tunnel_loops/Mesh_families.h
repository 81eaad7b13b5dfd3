#ifndef BENCHMARK_MESH_FAMILIES_H
#define BENCHMARK_MESH_FAMILIES_H

#include "generators/generators.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Mesh_families.h
/// Surfaces of any size, each of which is hard in its own way: vertices with many neighbours, faces
/// that are long and thin, many handles, many components, and loops that meet everywhere.

namespace mesh_families {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Soup;

/// makes surfaces of about so many faces; where each is another by chance, several.
struct Family
{
  std::string name;
  std::function<Soup(std::size_t faces, unsigned int seed)> make;
  unsigned int number_of_seeds = 1;
};

inline Soup make(const std::string& name,
                 std::size_t faces,
                 std::size_t genus,
                 std::size_t parts,
                 unsigned int seed) {
  for(const generators::Kind& kind : generators::kinds())
    if(kind.name == name) {
      generators::Request request = {faces, genus, seed};
      request.parts = parts;
      return kind.make(request);
    }
  throw std::runtime_error("no such kind of mesh: " + name);
}

/// a family of a kind, of the same genus at all sizes.
inline Family of_genus(const std::string& name, std::size_t genus, std::size_t parts = 1) {
  return {name + " of genus " + std::to_string(genus), [=](std::size_t faces, unsigned int seed) {
            return make(name, faces, genus, parts, seed);
          }};
}

/// a family of a kind, with a handle for each so many faces.
inline Family with_handles(const std::string& name,
                           std::size_t faces_per_handle,
                           unsigned int number_of_seeds = 1) {
  return {name + ", a handle per " + std::to_string(faces_per_handle) + " faces",
          [=](std::size_t faces, unsigned int seed) {
            return make(name, faces, faces / faces_per_handle, 1, seed);
          },
          number_of_seeds};
}

inline Soup scaled(Soup soup, double factor) {
  for(auto& point : soup.points)
    for(double& x : point)
      x *= factor;
  return soup;
}

/// spheres of so many faces, one in another.
inline Soup nested_spheres(std::size_t faces, std::size_t faces_of_each) {
  const Soup sphere = make("sphere", faces_of_each, 0, 1, 1);
  std::vector<Soup> shells;
  for(std::size_t i = 0; i < faces / sphere.triangles.size(); ++i)
    shells.push_back(scaled(sphere, double(i + 1)));
  return generators::joined(shells);
}

/// tubes in each other, each with so many faces, around the same circle.
inline Soup nested_tori(std::size_t faces, std::size_t faces_of_each) {
  const Soup torus = make("torus", faces_of_each, 1, 1, 1);
  const std::size_t number = faces / torus.triangles.size();
  std::vector<Soup> shells;
  for(std::size_t i = 0; i < number; ++i) {
    Soup shell = torus;
    const double factor = double(i + 1) / double(number);
    for(auto& [x, y, z] : shell.points) { // towards the circle of radius one
      const double radius = std::sqrt(x * x + y * y);
      const double moved = 1. + factor * (radius - 1.);
      x *= moved / radius;
      y *= moved / radius;
      z *= factor;
    }
    shells.push_back(std::move(shell));
  }
  return generators::joined(shells);
}

inline Soup many_tori(std::size_t faces, std::size_t faces_of_each) {
  const Soup torus = make("torus", faces_of_each, 1, 1, 1);
  return generators::disjoint_union(std::vector<Soup>(faces / torus.triangles.size(), torus));
}

/// a family whose surfaces lie in no simple way.
inline Family askew(const Family& family) {
  return {family.name + ", askew",
          [=](std::size_t faces, unsigned int seed) {
            return generators::askew(family.make(faces, seed));
          },
          family.number_of_seeds};
}

inline const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      of_genus("hubs", 20),
      askew(of_genus("hubs", 20)),
      with_handles("hubs", 400),
      of_genus("fan", 0),
      of_genus("plates", 20, 3),
      askew(of_genus("plates", 20, 3)),
      with_handles("plates", 100),
      of_genus("bars", 20, 3),
      askew(of_genus("bars", 20, 3)),
      with_handles("bars", 40),
      with_handles("chain", 400),
      {"nested spheres",
       [](std::size_t faces, unsigned int) { return nested_spheres(faces, 500); }},
      {"nested tori", [](std::size_t faces, unsigned int) { return nested_tori(faces, 500); }},
      {"many tori", [](std::size_t faces, unsigned int) { return many_tori(faces, 200); }},
      with_handles("random", 1000, 8),
      with_handles("random", 100, 8),
      with_handles("sponge", 60),
      with_handles("gyroid", 1000),
      with_handles("lattice", 700),
      with_handles("multi-torus", 400),
      with_handles("interlaced", 1000),
      of_genus("torus", 1)};
  return all;
}

} // namespace mesh_families

#endif // BENCHMARK_MESH_FAMILIES_H
