// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_ring.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_rings.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cells.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Builds a coarse mesh: cells grow from vertices spread over the fine one, and those that are not fit
(see `Cell_ring`) are divided until all are.

What is not fit gets more centres, and is labelled again together with what is beside it; what is
not fit and small falls apart into its vertices. Each time there are more cells, so there always is
an answer, in the end the fine mesh itself. Nothing depends on the number of threads.

Linear, as long as few cells have to be divided. Where many have, as at noise or on long thin
triangles, the mesh is not coarse: it can be asked for within limits.
*/
class Coarse_mesh_builder
{
public:
  /// lets cells grow from each `spacing`-th vertex, about. The seeds, of which there is one in each
  /// component, are centres of cells. Who else there is to find these cells may be given, too.
  Coarse_mesh_builder(Execution execution,
                      const Flat_mesh& mesh,
                      Index spacing,
                      std::vector<Index> seeds,
                      const Find_first_cells& find_first_cells = {})
      : execution_(execution)
      , mesh_(mesh)
      , seeds_(std::move(seeds))
      , cells_(execution, mesh)
      , rings_([this] { return std::make_unique<Cell_ring>(cells_.view()); }) {
    CGAL_precondition(spacing > 0);
    if(!find_first_cells || !have_found(find_first_cells, spacing)) {
      start(spacing);
      first_ = Cell_rings(centres());
      look(first_, [](std::size_t) { return false; });
    }
    number_of_cells_ = first_.size();
    for(std::size_t i = 0; i < first_.size(); ++i)
      if(first_.number_of_neighbors(i) == 0)
        unfit_.push_back(first_.cell(i));
  }

  /// about as many vertices as a coarse mesh will have.
  std::size_t expected_number_of_vertices() const {
    return number_of_cells_ + cells_for_unfit_cell * unfit_.size();
  }

  /// a coarse mesh. There is none if it would have more vertices than \p most_vertices, or if the
  /// work, in edges looked at to divide cells, is more than \p most_work; then it can be asked for
  /// again with larger limits, and what has been done is not lost.
  std::optional<Coarse_mesh> build(std::size_t most_vertices = unlimited,
                                   std::size_t most_work = unlimited) {
    while(!unfit_.empty() && number_of_cells_ <= most_vertices && work_ <= most_work)
      divide_unfit_cells();
    if(!unfit_.empty() || number_of_cells_ > most_vertices)
      return std::nullopt;
    return coarse_mesh();
  }

private:
  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  static constexpr std::size_t few = 8; // vertices
  static constexpr std::size_t parts_of_unfit_cell = 4;
  // So many more there are in the end, on scans.
  static constexpr std::size_t cells_for_unfit_cell = 6;

  Coarse_mesh coarse_mesh() {
    Coarse_mesh coarse;
    coarse.fine = &mesh_;
    coarse.centre = centres();
    number_of_cell_.resize(mesh_.number_of_vertices());
    for_each_index(execution_, coarse.centre.size(), [&](std::size_t i) {
      number_of_cell_[coarse.centre[i]] = static_cast<Index>(i);
    });
    const Cell_rings all = rings_of(coarse.centre);
    set_rings(all, coarse);
    set_vertices(all, coarse);
    coarse.parent.resize(mesh_.number_of_vertices());
    for_each_index(execution_, coarse.parent.size(),
                   [&](std::size_t v) { coarse.parent[v] = cells_.parent(static_cast<Index>(v)); });
    return coarse;
  }

  // ---- the first cells

  // Whether somebody else has found them.
  bool have_found(const Find_first_cells& find_first_cells, Index spacing) {
    First_cells cells = {spacing,
                         seeds_,
                         mesh_.first_hub,
                         mesh_.number_of_hubs,
                         cells_.links(),
                         cells_.are_vertices(),
                         [this](First_cells& all) { find_centres(all); }};
    if(!find_first_cells(cells)) {
      if(cells.are_begun)
        cells_.open_all(execution_);
      return false;
    }
    first_ = Cell_rings(std::move(cells.centres));
    look(first_, [&](std::size_t i) {
      const Cell_look& look = cells.looks[i];
      if(look.number_of_neighbors == no_index)
        return false;
      if(look.number_of_neighbors > 0)
        first_.set(i, look, cells.neighbors.data() + look.first);
      return true;
    });
    return true;
  }

  // Memory is got by those who touch it first: by all threads.
  void find_centres(First_cells& cells) const {
    cells.centres = centres();
    cells.looks.resize(cells.centres.size());
    cells.neighbors.resize(First_cells::neighbors_of_cell * cells.centres.size());
    for_each_index(execution_, cells.looks.size(), [&](std::size_t i) { cells.looks[i] = {}; });
    for_each_index(execution_, cells.neighbors.size(),
                   [&](std::size_t i) { cells.neighbors[i] = {}; });
  }

  void start(Index spacing) {
    for(Index v = 0; v < mesh_.first_hub; v += spacing)
      cells_.add_cell(v);
    for(Index seed : seeds_)
      cells_.add_cell(seed);
    // A cell around a vertex of many neighbours would take them all, and be beside everything.
    for_each_index(execution_, mesh_.number_of_vertices(), [this](std::size_t i) {
      const Index v = static_cast<Index>(i);
      if(mesh_.is_hub(v) || mesh_.ring(v).size() > many_neighbors)
        cells_.add_vertex(v);
    });
    cells_.grow(execution_, vertices_with<Uninitialized_vector<Index>>([&](Index v) {
                  return !cells_.is_centre(v);
                }),
                [](Index) { return true; });
    // Those in a small component of which all centres have many neighbours.
    for(Index v : vertices_with([&](Index v) { return cells_.cell(v) == no_index; }))
      cells_.add_vertex(v);
  }

  // Looks at the cells, but the i-th one if `has_taken(i)` says that it is done.
  template <typename Predicate> void look(Cell_rings& all, const Predicate& has_taken) {
    execution_.for_ranges(all.size(), Cell_rings::grain, [&](std::size_t begin, std::size_t end) {
      const auto ring = rings_.borrow();
      for(std::size_t i = begin; i < end; ++i)
        if(!has_taken(i) && ring->look(all.cell(i)))
          all.set(i, *ring);
    });
  }

  template <typename Vertices = std::vector<Index>, typename Predicate>
  Vertices vertices_with(const Predicate& predicate) const {
    return collect_many<Vertices>(execution_, mesh_.number_of_vertices(),
                                  [&](std::size_t begin, std::size_t end) {
                                    std::vector<Index> own;
                                    for(Index v = static_cast<Index>(begin); v < end; ++v)
                                      if(predicate(v))
                                        own.push_back(v);
                                    return own;
                                  });
  }

  std::vector<Index> centres() const {
    return vertices_with([&](Index v) { return cells_.is_centre(v); });
  }

  // ---- until all cells are fit

  void divide_unfit_cells() {
    std::vector<Index> small_cells, large_cells, own;
    for(Index cell : divisible(unfit_)) {
      cells_.list(cell, own);
      (own.size() < few ? small_cells : large_cells).push_back(cell);
    }
    std::vector<Index> changed = dissolve(small_cells);
    if(!large_cells.empty()) {
      const std::vector<Index> vertices = divide(large_cells);
      changed.insert(changed.end(), vertices.begin(), vertices.end());
    }
    const std::vector<Index> cells = with_neighbors(centres_among(std::move(changed)));
    is_changed_.resize(mesh_.number_of_vertices(), 0);
    for(Index cell : cells)
      is_changed_[cell] = 1;
    unfit_ = unfit_among(cells);
  }

  std::vector<Index> unfit_among(const std::vector<Index>& cells) {
    return collect<Index>(
        execution_, cells.size(),
        [&](std::size_t begin, std::size_t end) {
          const auto ring = rings_.borrow();
          std::vector<Index> unfit;
          for(std::size_t i = begin; i < end; ++i)
            if(!ring->look(cells[i]))
              unfit.push_back(cells[i]);
          return unfit;
        },
        Cell_rings::grain);
  }

  // Concatenates what `f(vertices, result)` appends for each cell with these vertices.
  template <typename Function>
  std::vector<Index> collect_of_cells(const std::vector<Index>& cells, const Function& f) const {
    return collect<Index>(
        execution_, cells.size(),
        [&](std::size_t begin, std::size_t end) {
          std::vector<Index> all, vertices;
          for(std::size_t i = begin; i < end; ++i) {
            cells_.list(cells[i], vertices);
            f(vertices, all);
          }
          return all;
        },
        Cell_rings::grain);
  }

  std::vector<Index> vertices_of(const std::vector<Index>& cells) const {
    return collect_of_cells(cells, [](const std::vector<Index>& own, std::vector<Index>& all) {
      all.insert(all.end(), own.begin(), own.end());
    });
  }

  std::vector<Index> sorted(std::vector<Index> numbers) const {
    sort(execution_, numbers.begin(), numbers.end(), std::less<>());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  std::vector<Index> centres_among(std::vector<Index> vertices) const {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                                  [&](Index v) { return !cells_.is_centre(v); }),
                   vertices.end());
    return sorted(std::move(vertices));
  }

  // The cells, and those beside them.
  std::vector<Index> with_neighbors(const std::vector<Index>& cells) {
    std::atomic<std::size_t> work{0};
    std::vector<Index> with_own =
        collect_of_cells(cells, [&](const std::vector<Index>& own, std::vector<Index>& all) {
          const std::size_t first = all.size();
          std::size_t number_of_edges = 0;
          all.push_back(own.front()); // the cell
          for(Index v : own) {
            number_of_edges += mesh_.ring(v).size();
            for(Index u : mesh_.ring(v))
              if(cells_.cell(u) != all.back())
                all.push_back(cells_.cell(u));
          }
          std::sort(all.begin() + first, all.end());
          all.erase(std::unique(all.begin() + first, all.end()), all.end());
          work += number_of_edges;
        });
    work_ += work;
    return sorted(std::move(with_own));
  }

  // Of cells that are not fit those that can be divided: in place of a vertex, those beside it.
  std::vector<Index> divisible(const std::vector<Index>& unfit) const {
    std::vector<Index> cells;
    for(Index cell : unfit)
      if(!cells_.is_alone(cell))
        cells.push_back(cell);
      else
        append_beside(cell, cells);
    return sorted(std::move(cells));
  }

  // Appends the cells that lie beside a vertex more than once; or all, if there are none.
  void append_beside(Index v, std::vector<Index>& cells) const {
    const Ring ring = mesh_.ring(v);
    std::vector<Index> around;
    for(Index p = 0; p < ring.size(); ++p)
      if(const Index cell = cells_.cell(ring[p]); cell != cells_.cell(ring[ring.next(p)]))
        around.push_back(cell);
    std::sort(around.begin(), around.end());
    const std::size_t before = cells.size();
    for(std::size_t i = 1; i < around.size(); ++i)
      if(around[i] == around[i - 1] && !cells_.is_alone(around[i]))
        cells.push_back(around[i]);
    if(cells.size() == before)
      for(Index u : ring)
        if(!cells_.is_alone(cells_.cell(u)))
          cells.push_back(cells_.cell(u));
  }

  // Gives cells more centres, and labels them again with those beside them. Returns the vertices.
  std::vector<Index> divide(const std::vector<Index>& cells) {
    const std::vector<Index> region = with_neighbors(cells);
    const std::vector<Index> vertices = vertices_of(region);
    std::vector<Index> added = region, own;
    for(Index cell : cells) {
      cells_.list(cell, own);
      for(std::size_t k = 1; k < parts_of_unfit_cell; ++k)
        added.push_back(own[k * own.size() / parts_of_unfit_cell]);
      number_of_cells_ += parts_of_unfit_cell - 1;
    }
    Uninitialized_vector<Index> open;
    grows_.resize(mesh_.number_of_vertices(), 0);
    for(Index v : vertices)
      if(!cells_.is_alone(v))
        cells_.open(v);
    for(Index v : added)
      if(!cells_.is_alone(v)) {
        cells_.add_cell(v);
        grows_[v] = 1;
      }
    for(Index v : vertices)
      if(!cells_.is_centre(v))
        open.push_back(v);
    cells_.grow(execution_, std::move(open), [this](Index cell) { return grows_[cell] != 0; });
    for(Index v : added)
      grows_[v] = 0;
    CGAL_assertion_msg(std::all_of(vertices.begin(), vertices.end(),
                                   [this](Index v) { return cells_.cell(v) != no_index; }),
                       "what was opened is connected with a centre");
    return vertices;
  }

  // Takes cells apart into their vertices, which it returns.
  std::vector<Index> dissolve(const std::vector<Index>& cells) {
    std::vector<Index> vertices = vertices_of(cells);
    number_of_cells_ += vertices.size() - cells.size();
    for(Index v : vertices)
      cells_.add_vertex(v);
    return vertices;
  }

  // ---- their mesh

  // Most cells are as they were at first.
  Cell_rings rings_of(const std::vector<Index>& centres) {
    Cell_rings all(centres);
    execution_.for_ranges(all.size(), Cell_rings::grain, [&](std::size_t begin, std::size_t end) {
      const auto ring = rings_.borrow();
      Cell_rings::Place old(first_, all.cell(begin));
      for(std::size_t i = begin; i < end; ++i) {
        const bool is_old = old.is_at(all.cell(i));
        if(is_old && (is_changed_.empty() || !is_changed_[all.cell(i)]))
          all.set(i, old);
        else if(ring->look(all.cell(i)))
          all.set(i, *ring);
        CGAL_assertion_msg(all.number_of_neighbors(i) > 0, "cells are divided until all are fit");
        if(is_old)
          old.advance();
      }
    });
    return all;
  }

  void set_rings(const Cell_rings& all, Coarse_mesh& coarse) const {
    coarse.mesh.row_begin.assign(all.size() + 1, 0);
    for_each_index(execution_, all.size(),
                   [&](std::size_t i) { coarse.mesh.row_begin[i] = all.number_of_neighbors(i); });
    const std::size_t size = sum_before_each(execution_, coarse.mesh.row_begin);
    coarse.mesh.neighbor.resize(size);
    coarse.gate.resize(size);
    std::vector<Stretch> stretches(all.number_of_ranges());
    for_each_index(
        execution_, stretches.size(),
        [&](std::size_t range) {
          Index place = coarse.mesh.row_begin[range * Cell_rings::grain];
          all.for_each_neighbor(range, [&](Index cell, const Cell_neighbor& neighbor) {
            coarse.mesh.neighbor[place] = number_of_cell_[neighbor.cell];
            coarse.gate[place++] = neighbor.gate;
            stretches[range].add(neighbor.way, mesh_.edge_length(cell, neighbor.cell));
          });
        },
        1);
    coarse.stretch = std::accumulate(stretches.begin(), stretches.end(), Stretch()).ratio();
  }

  // Of ways, over the distances of their ends.
  struct Stretch
  {
    double ways = 0., distances = 0.;

    void add(double way, double distance) {
      ways += way;
      distances += distance;
    }
    friend Stretch operator+(Stretch a, const Stretch& b) {
      a.add(b.ways, b.distances);
      return a;
    }
    double ratio() const { return distances > 0. ? ways / distances : 1.; }
  };

  void set_vertices(const Cell_rings& all, Coarse_mesh& coarse) const {
    Flat_mesh& mesh = coarse.mesh;
    const std::size_t n = coarse.centre.size();
    mesh.points.resize(n);
    mesh.original.resize(n);
    mesh.component.resize(n);
    for_each_index(execution_, n, [&](std::size_t i) {
      mesh.points[i] = all.point(i);
      mesh.original[i] = mesh_.original[coarse.centre[i]];
      mesh.component[i] = mesh_.component[coarse.centre[i]];
    });
    for(Index seed : seeds_)
      mesh.seeds.push_back(number_of_cell_[seed]);
    mesh.half_scale = mesh_.half_scale;
    mesh.number_of_hubs = mesh_.number_of_hubs;
    mesh.first_hub = static_cast<Index>(n - mesh.number_of_hubs);
    mesh.find_places_in_long_rings();
    mesh.count_handles();
    CGAL_postcondition_msg(mesh.genus == mesh_.genus, "a coarse mesh is of the same topology");
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Cells cells_;
  Workspace_pool<Cell_ring> rings_;
  Cell_rings first_;             // before any cell was divided
  std::vector<char> is_changed_; // by cell, since then
  std::vector<Index> unfit_;     // cells
  std::size_t number_of_cells_ = 0, work_ = 0;
  std::vector<char> grows_;                    // by centre, in a region that is labelled again
  Uninitialized_vector<Index> number_of_cell_; // by centre
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_BUILDER_H
