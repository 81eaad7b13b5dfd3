// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PAGED_REGION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PAGED_REGION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Located_cell.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Walls.h>
#include <CGAL/Handle_tunnel_loops/internal/device/atomics.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/*!
Where many loop passes run at once, each in memory proportional to the region it covers: the
vertices of the mesh, which are numbered along a space-filling curve, are taken in pages of sixteen,
and a hash table holds the pages that the passes have come to. A cell is a place in the table, so
that neighbours are mostly near in memory, and no cell knows more of its vertex than its page does.
*/
template <typename Loop_set> class Paged_region
{
public:
  static constexpr Index page_size = 16;
  static constexpr std::uint64_t no_page = ~std::uint64_t(0);

  /// The arrays of the table.
  struct Table
  {
    Span<std::uint64_t> keys; ///< pass and page; a power of two of them, first `no_page`
    Index* number_of_pages;
    Index limit;                    ///< so many pages may be used
    Span<const Index> loops;        ///< by pass, the number of its loop
    Span<std::uint32_t> is_starved; ///< by pass, whether it found no room
  };

  Paged_region(const Mesh_view& mesh, const Walls<Loop_set>& walls, const Table& table)
      : mesh_(mesh)
      , walls_(walls)
      , table_(table) {}

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }
  CGAL_HTL_HOST_DEVICE const Walls<Loop_set>& walls() const { return walls_; }
  CGAL_HTL_HOST_DEVICE static bool has_walls() { return true; }
  CGAL_HTL_HOST_DEVICE Index loop(Index pass) const { return table_.loops[pass]; }

  /// what a cell stands for: of one that is known since before the last barrier. Who has put it in
  /// knows, and does not ask.
  CGAL_HTL_HOST_DEVICE Located_cell located(Index cell) const {
    const std::uint64_t key = racy_load(table_.keys[cell / page_size]);
    return {cell, static_cast<Index>(key) * page_size + cell % page_size,
            static_cast<Index>(key >> 32)};
  }

  /// the cell of vertex `u` in the pass of a cell; `no_index` if the pass has not come near it.
  CGAL_HTL_HOST_DEVICE Index find(const Located_cell& c, Index u) const {
    return is_in_page(c, u) ? cell_in_page(c, u) : find_in_pass(c.pass, u);
  }
  CGAL_HTL_HOST_DEVICE Index find_in_pass(Index pass, Index u) const {
    const std::uint64_t key = key_of(pass, u);
    const std::size_t mask = table_.keys.size() - 1;
    std::size_t place = scrambled(key) & mask;
    CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < longest_run; ++i) {
      const std::uint64_t present = racy_load(table_.keys[place]);
      if(present == key)
        return static_cast<Index>(place) * page_size + u % page_size;
      if(present == no_page)
        break;
      place = (place + 1) & mask;
    }
    return no_index;
  }

  /// the same, but makes room for it; `no_index` if there is none, and then the pass is starved.
  CGAL_HTL_HOST_DEVICE Index insert(const Located_cell& c, Index u) const {
    return is_in_page(c, u) ? cell_in_page(c, u) : insert_in_pass(c.pass, u);
  }
  CGAL_HTL_HOST_DEVICE Index insert_in_pass(Index pass, Index u) const {
    const std::uint64_t key = key_of(pass, u);
    const std::size_t mask = table_.keys.size() - 1;
    std::size_t place = scrambled(key) & mask;
    CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < longest_run; ++i) {
      std::uint64_t present = racy_load(table_.keys[place]);
      if(present == no_page) {
        if(racy_load(*table_.number_of_pages) >= table_.limit)
          break;
        present = compare_and_swap(table_.keys[place], no_page, key);
        if(present == no_page) {
          fetch_add(*table_.number_of_pages, 1);
          present = key;
        }
      }
      if(present == key)
        return static_cast<Index>(place) * page_size + u % page_size;
      place = (place + 1) & mask;
    }
    starve(pass);
    return no_index;
  }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(const Located_cell& c) const {
    return walls_.may_be_beside(loop(c.pass), c.vertex);
  }
  CGAL_HTL_HOST_DEVICE bool is_wall(const Located_cell& c, Index u) const {
    return walls_.is_wall(loop(c.pass), c.vertex, u);
  }

  CGAL_HTL_HOST_DEVICE void starve(Index pass) const {
    racy_store(table_.is_starved[pass], std::uint32_t(1));
  }
  CGAL_HTL_HOST_DEVICE bool is_starved(Index pass) const {
    return racy_load(table_.is_starved[pass]) != 0;
  }

private:
  // A table that is half full has runs far shorter than this.
  static constexpr Index longest_run = 256;

  // Keys are never taken out. A reader who misses one that is being put in misses a vertex at rest.
  CGAL_HTL_HOST_DEVICE static std::uint64_t key_of(Index pass, Index u) {
    return std::uint64_t(pass) << 32 | u / page_size;
  }

  CGAL_HTL_HOST_DEVICE static bool is_in_page(const Located_cell& c, Index u) {
    return c.vertex / page_size == u / page_size;
  }
  CGAL_HTL_HOST_DEVICE static Index cell_in_page(const Located_cell& c, Index u) {
    return c.cell - c.cell % page_size + u % page_size;
  }

  CGAL_HTL_HOST_DEVICE static std::uint64_t scrambled(std::uint64_t x) {
    x ^= x >> 29;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 32;
    x *= 0x94d049bb133111ebu;
    return x ^ x >> 31;
  }

  Mesh_view mesh_;
  Walls<Loop_set> walls_;
  Table table_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PAGED_REGION_H
