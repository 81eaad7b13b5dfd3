// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_JUDGE_CASES_H
#define BENCHMARK_JUDGE_CASES_H

#include "Removal_judge.h"

#include <cstdio>
#include <set>
#include <string>

/// \file Judge_cases.h
/// Removals made by hand, of which all is known, so that the judge is judged as well.

namespace judge {

/// Removals of the handle of a plate of 3 x 3 unit cubes without the one in the middle.
class Judge_cases
{
public:
  /// the number of answers that are wrong, which are printed.
  std::size_t operator()() {
    plain_fill();
    plain_cut();
    fill_that_takes_beside();
    fill_with_spire();
    folds();
    std::printf("%zu of %zu answers of the judge are wrong\n", wrong_, asked_);
    return wrong_;
  }

private:
  using Cube = std::array<int, 3>;

  // The surface of some cubes, which have no single edge or corner in common.
  class Surface_of_cubes
  {
  public:
    explicit Surface_of_cubes(const std::set<Cube>& cubes) {
      for(const Cube& cube : cubes)
        for(std::size_t axis = 0; axis < 3; ++axis)
          for(const int side : {0, 1}) {
            Cube beside = cube;
            beside[axis] += 2 * side - 1;
            if(cubes.count(beside) == 0)
              add_square(cube, axis, side);
          }
    }

    Mesh mesh;
    std::map<Cube, Mesh::Vertex_index> vertices;

  private:
    Mesh::Vertex_index vertex(const Cube& place) {
      const auto [at, is_new] = vertices.emplace(place, Mesh::Vertex_index());
      if(is_new)
        at->second = mesh.add_vertex({double(place[0]), double(place[1]), double(place[2])});
      return at->second;
    }

    void add_square(const Cube& cube, std::size_t axis, int side) {
      std::array<Mesh::Vertex_index, 4> v;
      for(std::size_t i = 0; i < 4; ++i) {
        Cube corner = cube;
        corner[axis] += side;
        corner[(axis + 1) % 3] += i == 1 || i == 2;
        corner[(axis + 2) % 3] += i >= 2;
        v[side == 1 ? i : 3 - i] = vertex(corner);
      }
      mesh.add_face(v[0], v[1], v[2]);
      mesh.add_face(v[0], v[2], v[3]);
    }
  };

  static std::set<Cube> plate(const std::set<Cube>& without) {
    std::set<Cube> cubes;
    for(int x = 0; x < 3; ++x)
      for(int y = 0; y < 3; ++y)
        if(without.count({x, y, 0}) == 0)
          cubes.insert({x, y, 0});
    return cubes;
  }

  static Report report(Way way) {
    Report report;
    report.removed.push_back({0, way, 4., 0., 0.});
    return report;
  }

  // All faces that the plate with the hole has not are said to be of the handle.
  static Verdict judged(Mesh after, Way way) {
    const Mesh before = Surface_of_cubes(plate({{1, 1, 0}})).mesh;
    const Removal_judge::Owners owners =
        after.add_property_map<Mesh::Face_index, std::size_t>("f:owner", 0).first;
    return Removal_judge(before, after, owners, report(way), {}).verdicts().front();
  }

  void expect(const char* what, double value, double expected, double tolerance = 1e-9) {
    ++asked_;
    if(std::abs(value - expected) <= tolerance)
      return;
    ++wrong_;
    std::printf("%s: %.6g instead of %.6g\n", what, value, expected);
  }

  void plain_fill() {
    const Verdict verdict = judged(Surface_of_cubes(plate({})).mesh, Way::FILL);
    expect("fill, net", verdict.net, 1.);
    expect("fill, added", verdict.gross.added, 1., 0.02);
    expect("fill, taken", verdict.gross.taken, 0.);
    expect("fill, circles", verdict.circles, CGAL_PI / 4.);
    expect("fill, caps", double(verdict.number_of_caps), 2.);
    expect("fill, flush", verdict.is_flush_fill(), 1.);
    expect("fill, displacement", verdict.displacement, 0.);
    expect("fill, fold", verdict.fold, 0.);
  }

  void plain_cut() {
    const Verdict verdict = judged(Surface_of_cubes(plate({{1, 1, 0}, {1, 0, 0}})).mesh, Way::CUT);
    expect("cut, net", verdict.net, -1.);
    expect("cut, added", verdict.gross.added, 0.);
    expect("cut, taken", verdict.gross.taken, 1., 0.02);
    expect("cut, wrong", verdict.wrong_gross(), 0.);
    expect("cut, caps", double(verdict.number_of_caps), 2.);
    expect("cut, displacement", verdict.displacement, 0.5);
    expect("cut as a fill",
           judged(Surface_of_cubes(plate({{1, 1, 0}, {1, 0, 0}})).mesh, Way::FILL).wrong_net(), 1.);
  }

  // A corner of the plate is lost, as large as what fills the hole.
  void fill_that_takes_beside() {
    const Verdict verdict = judged(Surface_of_cubes(plate({{0, 0, 0}})).mesh, Way::FILL);
    expect("fill and corner, net", verdict.wrong_net(), 0.);
    expect("fill and corner, added", verdict.gross.added, 1., 0.02);
    expect("fill and corner, wrong", verdict.wrong_gross(), 1., 0.02);
  }

  // Faces over the hole rise to a point 5 above the plate.
  void fill_with_spire() {
    Surface_of_cubes surface(plate({}));
    Mesh& mesh = surface.mesh;
    const Mesh::Vertex_index apex = mesh.add_vertex({1.5, 1.5, 6.});
    const Mesh::Vertex_index a = surface.vertices.at({1, 1, 1}), b = surface.vertices.at({2, 1, 1}),
                             c = surface.vertices.at({2, 2, 1}), d = surface.vertices.at({1, 2, 1});
    std::vector<Mesh::Face_index> top;
    for(const Mesh::Face_index f : mesh.faces()) {
      const auto around = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
      if(std::all_of(around.begin(), around.end(),
                     [&](auto v) { return v == a || v == b || v == c || v == d; }))
        top.push_back(f);
    }
    for(const Mesh::Face_index f : top)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    for(const auto& [from, to] :
        {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
      mesh.add_face(from, to, apex);
    const Verdict verdict = judged(mesh, Way::FILL);
    expect("spire, net", verdict.net, 1. + 5. / 3.);
    expect("spire, circles", verdict.circles, 2. * std::sqrt(25.25) * CGAL_PI / 4.);
    expect("spire, displacement", verdict.displacement, std::sqrt(25.25));
    expect("spire, flush", verdict.is_flush_fill(), 0.);
  }

  static Mesh hinge(double bend) {
    const double angle = bend * CGAL_PI / 180.;
    Mesh mesh;
    const auto a = mesh.add_vertex({0., 0., 0.}), b = mesh.add_vertex({0., 1., 0.}),
               c = mesh.add_vertex({1., 0.5, 0.}),
               d = mesh.add_vertex({-std::cos(angle), 0.5, std::sin(angle)});
    mesh.add_face(a, c, b);
    mesh.add_face(a, b, d);
    return mesh;
  }

  static double largest_fold(const Mesh& before, const Mesh& after) {
    const Old_folds folds(before, 1.);
    double largest = 0.;
    for(const Mesh::Edge_index e : after.edges())
      largest = (std::max)(largest, folds.new_fold(after, e));
    return largest;
  }

  void folds() {
    expect("new fold", largest_fold(hinge(0.), hinge(170.)), 170.);
    expect("sharper fold", largest_fold(hinge(130.), hinge(170.)), 170.);
    expect("old fold", largest_fold(hinge(170.), hinge(170.)), 0.);
    expect("slight fold", largest_fold(hinge(0.), hinge(110.)), 0.);
  }

  std::size_t asked_ = 0, wrong_ = 0;
};

} // namespace judge

#endif // BENCHMARK_JUDGE_CASES_H
