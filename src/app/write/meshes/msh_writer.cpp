// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/meshes/msh_writer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

/// A group as both versions of the format have it, which count nodes from 1.
template <std::size_t n> struct Msh_block
{
  std::string name;
  std::vector<std::array<std::uint32_t, n>> elements;
};

struct Msh_blocks
{
  std::vector<Msh_block<3>> triangles;
  std::vector<Msh_block<2>> lines;

  std::size_t size() const { return triangles.size() + lines.size(); }
};

constexpr int type_of(const Msh_block<3>&) { return 2; }
constexpr int type_of(const Msh_block<2>&) { return 1; }

// Calls `visit(block, dimension, number of the group)` for all.
template <typename Visit> void for_each(const Msh_blocks& blocks, Visit visit) {
  std::size_t number = 0;
  for(const Msh_block<3>& block : blocks.triangles)
    visit(block, 2, ++number);
  for(const Msh_block<2>& block : blocks.lines)
    visit(block, 1, ++number);
}

std::size_t number_of_elements(const Msh_blocks& blocks) {
  std::size_t count = 0;
  for_each(blocks, [&](const auto& block, int, std::size_t) { count += block.elements.size(); });
  return count;
}

Msh_blocks blocks_of(const generators::Soup& mesh, const Named_groups& groups) {
  Msh_blocks blocks;
  std::vector<char> has_group(mesh.triangles.size(), 0);
  for(const Named_faces& group : groups.faces) {
    blocks.triangles.push_back({group.name, {}});
    for(const std::uint32_t f : group.faces) {
      blocks.triangles.back().elements.push_back(mesh.triangles[f]);
      has_group[f] = 1;
    }
  }
  Msh_block<3> others = {"surface", {}};
  for(std::size_t f = 0; f < mesh.triangles.size(); ++f)
    if(has_group[f] == 0)
      others.elements.push_back(mesh.triangles[f]);
  if(!others.elements.empty())
    blocks.triangles.push_back(std::move(others));
  for(const Named_edges& group : groups.edges)
    blocks.lines.push_back({group.name, group.edges});
  return blocks;
}

void write_header(Text_writer& out, const char* version, const Msh_blocks& blocks) {
  out << "$MeshFormat\n"
      << version << " 0 8\n$EndMeshFormat\n$PhysicalNames\n"
      << blocks.size() << '\n';
  for_each(blocks, [&](const auto& block, int dimension, std::size_t number) {
    out << dimension << ' ' << number << " \"" << block.name << "\"\n";
  });
  out << "$EndPhysicalNames\n";
}

void write_coordinates(Text_writer& out, const std::array<double, 3>& point) {
  out << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
}

template <std::size_t n>
void write_corners(Text_writer& out, const std::array<std::uint32_t, n>& element) {
  for(const std::uint32_t v : element)
    out << ' ' << std::size_t(v) + 1;
  out << '\n';
}

// Of all points, the least corner and then the largest.
std::array<std::array<double, 3>, 2> box_of(const generators::Soup& mesh) {
  if(mesh.points.empty())
    return {};
  std::array<std::array<double, 3>, 2> box = {mesh.points[0], mesh.points[0]};
  for(const std::array<double, 3>& point : mesh.points)
    for(std::size_t i = 0; i < 3; ++i) {
      box[0][i] = (std::min)(box[0][i], point[i]);
      box[1][i] = (std::max)(box[1][i], point[i]);
    }
  return box;
}

// An entity for each group, of its number; all in the box of the mesh.
void write_entities(Text_writer& out, const generators::Soup& mesh, const Msh_blocks& blocks) {
  std::string box;
  for(const std::array<double, 3>& corner : box_of(mesh))
    for(const double x : corner) {
      box += ' ';
      append_number(box, x);
    }
  out << "$Entities\n0 " << blocks.lines.size() << ' ' << blocks.triangles.size() << " 0\n";
  const std::size_t first_line = blocks.triangles.size() + 1;
  const auto write = [&](std::size_t number) { out << number << box << " 1 " << number << " 0\n"; };
  for(std::size_t number = first_line; number <= blocks.size(); ++number)
    write(number);
  for(std::size_t number = 1; number < first_line; ++number)
    write(number);
  out << "$EndEntities\n";
}

// All are of the first surface, as far as there is one.
void write_nodes(Text_writer& out, const generators::Soup& mesh, const Msh_blocks& blocks) {
  const std::size_t n = mesh.points.size();
  if(n == 0 || blocks.size() == 0) {
    out << "$Nodes\n0 0 0 0\n$EndNodes\n";
    return;
  }
  out << "$Nodes\n1 " << n << " 1 " << n << '\n'
      << (blocks.triangles.empty() ? 1 : 2) << " 1 0 " << n << '\n';
  for(std::size_t v = 1; v <= n; ++v)
    out << v << '\n';
  for(const std::array<double, 3>& point : mesh.points)
    write_coordinates(out, point);
  out << "$EndNodes\n";
}

} // namespace

void write_msh4(Text_writer& out, const generators::Soup& mesh, const Named_groups& groups) {
  const Msh_blocks blocks = blocks_of(mesh, groups);
  const std::size_t n = number_of_elements(blocks);
  write_header(out, "4.1", blocks);
  write_entities(out, mesh, blocks);
  write_nodes(out, mesh, blocks);
  out << "$Elements\n" << blocks.size() << ' ' << n << ' ' << (n == 0 ? 0 : 1) << ' ' << n << '\n';
  std::size_t number_of_element = 0;
  for_each(blocks, [&](const auto& block, int dimension, std::size_t number) {
    out << dimension << ' ' << number << ' ' << type_of(block) << ' ' << block.elements.size()
        << '\n';
    for(const auto& element : block.elements) {
      out << ++number_of_element;
      write_corners(out, element);
    }
  });
  out << "$EndElements\n";
}

void write_msh2(Text_writer& out, const generators::Soup& mesh, const Named_groups& groups) {
  const Msh_blocks blocks = blocks_of(mesh, groups);
  write_header(out, "2.2", blocks);
  out << "$Nodes\n" << mesh.points.size() << '\n';
  for(std::size_t v = 0; v < mesh.points.size(); ++v) {
    out << v + 1 << ' ';
    write_coordinates(out, mesh.points[v]);
  }
  out << "$EndNodes\n$Elements\n" << number_of_elements(blocks) << '\n';
  std::size_t number_of_element = 0;
  for_each(blocks, [&](const auto& block, int, std::size_t number) {
    for(const auto& element : block.elements) { // in a group, and in an entity of its number
      out << ++number_of_element << ' ' << type_of(block) << " 2 " << number << ' ' << number;
      write_corners(out, element);
    }
  });
  out << "$EndElements\n";
}

} // namespace htloops
