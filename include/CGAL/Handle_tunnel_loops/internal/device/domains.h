// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DOMAINS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DOMAINS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/field_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// The arrays of a `Crossing_index`, and which of its loops are walls to the pass of a loop: those
/// in a set of type `Loop_set`, made from the number of the loop.
template <typename Loop_set> struct Wall_arrays
{
  Span<const Index> begins;
  Span<const Crossing_entry> entries;

  CGAL_HTL_HOST_DEVICE bool is_wall(Index loop, Index u, Index v) const {
    bool result = false;
    for_each_wall(loop, u, [&](Index other) { result = result || other == v; });
    return result;
  }

  /// a bit for each of some neighbours of `u`: whether there is a wall between.
  CGAL_HTL_HOST_DEVICE std::uint32_t
  walls_among(const Index (&neighbors)[stencil_width], Index loop, Index u) const {
    std::uint32_t bits = 0;
    for_each_wall(loop, u, [&](Index other) {
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        bits |= neighbors[i] == other ? 1u << i : 0u;
    });
    return bits;
  }

  /// whether there may be walls beside `v`, for a field whose sources are the ends of the crossings
  /// of a loop. Where it is the only wall, there are walls beside its sources.
  CGAL_HTL_HOST_DEVICE bool may_be_beside(Index v, bool is_source) const {
    return Loop_set::is_one ? is_source : begins[v] != begins[v + 1];
  }

  /// calls `f` for each other loop that is a wall between `u` and `v`.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void
  for_each_other_wall(Index loop, Index u, Index v, const Function& f) const {
    const Loop_set barred = {loop};
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u]; i < begins[u + 1]; ++i)
      if(entries[i].other == v && entries[i].loop != loop && barred.contains(entries[i].loop))
        f(entries[i].loop);
  }

  /// how often loop `loop` is crossed on the way from `u` to `v`, an edge or a point.
  CGAL_HTL_HOST_DEVICE int crossings(Index loop, Index u, Index v) const {
    int sum = 0;
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u]; i < begins[u + 1]; ++i)
      if(entries[i].other == v && entries[i].loop == loop)
        sum += entries[i].sign;
    return sum;
  }

private:
  // Calls `f` for the other ends of the edges of `u` on which there are walls. The entries are
  // sorted by loop.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each_wall(Index loop, Index u, const Function& f) const {
    const Loop_set barred = {loop};
    const Index begin = begins[u];
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u + 1]; i > begin && !barred.are_all_after(entries[i - 1].loop); --i)
      if(barred.contains(entries[i - 1].loop))
        f(entries[i - 1].other);
  }
};

/// Where one field runs over all of the mesh: its cells are the vertices. `Paged_domain` provides
/// the same for many passes at once.
class Whole_mesh_domain
{
public:
  /// All loops are walls.
  explicit Whole_mesh_domain(const Mesh_view& mesh, const Wall_arrays<Loops_from>& walls = {})
      : mesh_(mesh)
      , walls_(walls) {}

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }
  CGAL_HTL_HOST_DEVICE bool has_walls() const { return !walls_.begins.empty(); }

  /// of a cell, all that a list of the band keeps.
  using Banded_cell = Index;
  static constexpr bool has_sides = false;

  CGAL_HTL_HOST_DEVICE static Banded_cell banded(const Located_cell& c) { return c.cell; }
  CGAL_HTL_HOST_DEVICE static Located_cell located(Banded_cell cell) { return {cell, cell, 0}; }
  CGAL_HTL_HOST_DEVICE static Index find(const Located_cell&, Index u) { return u; }
  CGAL_HTL_HOST_DEVICE static void
  insert(Index (&)[stencil_width], const Index (&)[stencil_width], Index) {}

  CGAL_HTL_HOST_DEVICE static bool is_starved(Index) { return false; }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index v, bool is_source) const {
    return has_walls() && walls_.may_be_beside(v, is_source);
  }
  CGAL_HTL_HOST_DEVICE std::uint32_t walls_among(const Index (&neighbors)[stencil_width],
                                                 const Located_cell& c) const {
    return walls_.walls_among(neighbors, 0, c.vertex);
  }

private:
  Mesh_view mesh_;
  Wall_arrays<Loops_from> walls_;
};

/*!
Where many loop passes run at once, each in memory proportional to the region it covers: the
vertices of the mesh, which are numbered along a space-filling curve, are taken in pages of sixteen,
and a pass is given a page of cells when it comes to the first of them. So neighbours are mostly
near in memory, and a directory of the passes leads from a vertex to its cell in one step.
*/
template <typename Loop_set> class Paged_domain
{
public:
  static constexpr Index page_size = 16;

  /// In the directory: no page yet, and one that is just being given out.
  static constexpr Index no_page = no_index, coming_page = no_index - 1;

  /// What a page stands for.
  struct Page
  {
    Index pass, first_vertex;
  };

  struct Table
  {
    Span<Index> directory; ///< by pass and sixteen vertices, a page; at first `no_page`
    Index number_of_rows;  ///< of the directory, for each pass
    Span<Page> pages;
    Index* number_of_pages;         ///< given out
    Span<const Index> loops;        ///< by pass, the number of its loop
    Span<std::uint32_t> is_starved; ///< by pass, whether it found no room
  };

  /// of a cell, all that a list of the band keeps.
  using Banded_cell = Located_cell;
  static constexpr bool has_sides = true;

  Paged_domain(const Mesh_view& mesh, const Wall_arrays<Loop_set>& walls, const Table& table)
      : mesh_(mesh)
      , walls_(walls)
      , table_(table) {}

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }
  CGAL_HTL_HOST_DEVICE const Wall_arrays<Loop_set>& walls() const { return walls_; }
  CGAL_HTL_HOST_DEVICE static bool has_walls() { return true; }
  CGAL_HTL_HOST_DEVICE Index loop(Index pass) const { return table_.loops[pass]; }

  CGAL_HTL_HOST_DEVICE static const Banded_cell& banded(const Located_cell& c) { return c; }
  CGAL_HTL_HOST_DEVICE static const Located_cell& located(const Banded_cell& c) { return c; }

  /// what a cell stands for: of one that is there since before the last barrier.
  CGAL_HTL_HOST_DEVICE Located_cell located(Index cell) const {
    const Page page = table_.pages[cell / page_size];
    return {cell, page.first_vertex + cell % page_size, page.pass};
  }

  /// the cell of vertex `u` in the pass of a cell; `no_index` if the pass has not come near it.
  CGAL_HTL_HOST_DEVICE Index find(const Located_cell& c, Index u) const {
    return find_in_pass(c.pass, u);
  }
  CGAL_HTL_HOST_DEVICE Index find_in_pass(Index pass, Index u) const {
    const Index page = racy_load(entry(pass, u));
    return page >= coming_page ? no_index : page * page_size + u % page_size;
  }

  /// finds the cells of some vertices of a pass, `no_index` beyond the last, that are not found
  /// yet, and makes room for them; if there is none, the pass is starved. (Threads take their first
  /// pages together, then their second ones: there is rarely a third.)
  CGAL_HTL_HOST_DEVICE void
  insert(Index (&cells)[stencil_width], const Index (&vertices)[stencil_width], Index pass) const {
    for(Index done = 0;;) {
      Index u = no_index;
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        if(vertices[i] != no_index && cells[i] == no_index && (done >> i & 1) == 0)
          u = vertices[i];
      if(u == no_index)
        return;
      const Index first = insert_in_pass(pass, u - u % page_size);
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        if(vertices[i] != no_index && vertices[i] / page_size == u / page_size) {
          cells[i] = first == no_index ? no_index : first + vertices[i] % page_size;
          done |= 1u << i;
        }
    }
  }
  CGAL_HTL_HOST_DEVICE Index insert_in_pass(Index pass, Index u) const {
    Index page = racy_load(entry(pass, u));
    if(page >= coming_page)
      page = take_page(pass, u);
    return page == no_page ? no_index : page * page_size + u % page_size;
  }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index v, bool is_source) const {
    return walls_.may_be_beside(v, is_source);
  }
  CGAL_HTL_HOST_DEVICE bool is_wall(const Located_cell& c, Index u) const {
    return walls_.is_wall(loop(c.pass), c.vertex, u);
  }
  CGAL_HTL_HOST_DEVICE std::uint32_t walls_among(const Index (&neighbors)[stencil_width],
                                                 const Located_cell& c) const {
    return walls_.walls_among(neighbors, loop(c.pass), c.vertex);
  }

  CGAL_HTL_HOST_DEVICE void starve(Index pass) const {
    racy_store(table_.is_starved[pass], std::uint32_t(1));
  }
  CGAL_HTL_HOST_DEVICE bool is_starved(Index pass) const {
    return racy_load(table_.is_starved[pass]) != 0;
  }

private:
  CGAL_HTL_HOST_DEVICE Index& entry(Index pass, Index u) const {
    return table_.directory[std::size_t(pass) * table_.number_of_rows + u / page_size];
  }

  CGAL_HTL_HOST_DEVICE Index take_page(Index pass, Index u) const {
    const Index page = take_page(entry(pass, u), {pass, u - u % page_size}, table_.pages.data(),
                                 static_cast<Index>(table_.pages.size()), table_.number_of_pages);
    if(page == no_page)
      starve(pass);
    return page;
  }

  // The thread that comes first gives out the page, the others wait for it: it waits for nobody. A
  // reader who misses the page misses vertices at rest. (A function that is called wants its
  // arguments one by one: to pass on the address of the region would cost registers.)
  CGAL_HTL_NO_INLINE CGAL_HTL_HOST_DEVICE static Index
  take_page(Index& entry, Page meaning, Page* pages, Index size, Index* number_of_pages) {
    Index page = compare_and_swap(entry, no_page, coming_page);
    if(page == no_page) {
      page = fetch_add(*number_of_pages, Index(1));
      if(page < size)
        pages[page] = meaning;
      else
        page = no_page;
      racy_store(entry, page);
    }
    while(page == coming_page)
      page = racy_load(entry);
    return page;
  }

  Mesh_view mesh_;
  Wall_arrays<Loop_set> walls_;
  Table table_;
};

struct Fill_rows
{
  Mesh_view mesh;
  Span<Neighbor_row> rows;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    const Ring ring = mesh.ring(v);
    Neighbor_row row;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      row.at[i] = i < ring.size() ? ring[i] : no_index;
    rows[v] = row;
  }
};

/// A mesh in the memory of an executor.
template <typename Executor> class Device_mesh
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  /// The rows are filled when the last copy has been waited for.
  Device_mesh(Executor& executor, const Mesh_view& host)
      : row_begin_(copy(executor, host.row_begin))
      , neighbor_(copy(executor, host.neighbor))
      , rows_(filled_rows(executor))
      , points_(copy(executor, host.points)) {}

  std::size_t number_of_vertices() const { return row_begin_.span().size() - 1; }

  Mesh_view view() const {
    return {points_.span(), row_begin_.span(), neighbor_.span(), rows_.span()};
  }

  static std::size_t bytes(const Mesh_view& host) {
    return host.points.size() * sizeof(double) +
           (host.row_begin.size() + host.neighbor.size()) * sizeof(Index) +
           host.number_of_vertices() * sizeof(Neighbor_row);
  }

private:
  template <typename T> static Buffer<T> copy(Executor& executor, const Span<const T>& values) {
    return uploaded(executor, values.data(), values.size());
  }

  Buffer<Neighbor_row> filled_rows(Executor& executor) const {
    auto rows = executor.template make<Neighbor_row>(number_of_vertices());
    const Mesh_view rings = {{}, row_begin_.span(), neighbor_.span(), {}};
    executor.for_each(number_of_vertices(), Fill_rows{rings, rows.span()});
    return rows;
  }

  Buffer<Index> row_begin_, neighbor_;
  Buffer<Neighbor_row> rows_;
  Buffer<double> points_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DOMAINS_H
