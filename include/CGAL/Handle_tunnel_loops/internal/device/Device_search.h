// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/domains.h>
#include <CGAL/Handle_tunnel_loops/internal/device/field_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/device/walk_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// The loops of a batch of passes, as the arrays of `Loop_sides`.
struct Host_sides
{
  std::vector<Index> loops; ///< by pass, the number of its loop
  std::vector<Time> last_steps;
  std::vector<Crossing> crossings;
  std::vector<Index> pass, begin;
  std::vector<double> along;
};

inline Host_sides
sides_of(const Flat_mesh& mesh, const Dual_loop_query& search, const std::vector<Index>& loops) {
  Host_sides sides;
  sides.loops = loops;
  sides.begin.push_back(0);
  std::vector<double> along;
  for(Index i = 0; i < loops.size(); ++i) {
    const Crossing_loop& loop = search.loops[loops[i]];
    measure_left_side(mesh, loop, along);
    sides.along.insert(sides.along.end(), along.begin(), along.end());
    sides.crossings.insert(sides.crossings.end(), loop.begin(), loop.end());
    sides.pass.insert(sides.pass.end(), loop.size(), i);
    sides.begin.push_back(static_cast<Index>(sides.crossings.size()));
    sides.last_steps.push_back(search.numbers_of_steps.empty() ? never
                                                               : search.numbers_of_steps[loops[i]]);
  }
  return sides;
}

/*!
A batch of loop passes that run at the same time, in one table of pages and one band, so that one
large pass and many small ones both fill the device. The fields run a few steps at a time on the
device; then the host sorts the meetings that there were, and one thread per pass closes walks at
them. What the fields did meanwhile lies later than the meetings, and changes nothing.
*/
template <typename Executor, typename Loop_set> class Search_batch
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;
  using Domain = Paged_domain<Loop_set>;
  using Page = typename Domain::Page;
  using Banded_cell = typename Domain::Banded_cell;

public:
  static constexpr Index page_size = Domain::page_size;

  /// How much memory is taken.
  struct Room
  {
    std::size_t number_of_pages;
    std::size_t walk_size; ///< of the walks in multiples of the loops
  };

  /// the bytes of a page and its share of everything that grows with the pages.
  static constexpr std::size_t bytes_per_page =
      sizeof(Page) + page_size * (2 * sizeof(float) + sizeof(Time) + sizeof(std::uint32_t) +
                                  2 * sizeof(Banded_cell) + 2 * sizeof(Index));

  /// of the directory.
  static std::size_t bytes_per_pass(std::size_t number_of_vertices) {
    return rows_per_pass(number_of_vertices) * sizeof(Index);
  }

  Search_batch(Executor& executor,
               const Mesh_view& mesh,
               const Wall_arrays<Loop_set>& walls,
               const Host_sides& sides,
               Index wanted_walks,
               std::uint64_t number_of_updates,
               const Room& room)
      : executor_(executor)
      , wanted_walks_(wanted_walks)
      , number_of_passes_(sides.loops.size())
      , crossings_(uploaded(executor, sides.crossings))
      , pass_(uploaded(executor, sides.pass))
      , begin_(uploaded(executor, sides.begin))
      , along_(uploaded(executor, sides.along))
      , loops_(uploaded(executor, sides.loops))
      , directory_(filled(executor,
                          number_of_passes_ * rows_per_pass(mesh.number_of_vertices()),
                          Index(Domain::no_page)))
      , pages_(executor.template make<Page>(room.number_of_pages))
      , number_of_pages_(filled(executor, 1, Index(0)))
      , is_starved_(filled(executor, number_of_passes_, std::uint32_t(0)))
      , values_{filled(executor, cells(room), 0.f), filled(executor, cells(room), 0.f)}
      , time_(filled(executor, cells(room), never))
      , state_(filled(executor, cells(room), std::uint32_t(0)))
      , bands_{executor.template make<Banded_cell>(cells(room)),
               executor.template make<Banded_cell>(cells(room))}
      , reached_(executor.template make<Index>(cells(room)))
      , back_(filled(executor, cells(room), no_index))
      , progress_{filled(executor, number_of_passes_, Time(0)),
                  filled(executor, number_of_passes_, Time(0))}
      , last_step_(uploaded(executor, sides.last_steps))
      , band_changes_{filled(executor, number_of_passes_, Index(0)),
                      filled(executor, number_of_passes_, Index(0)),
                      filled(executor, number_of_passes_, Index(0))}
      , band_sizes_(filled(executor, number_of_passes_, Index(0)))
      , updates_(filled(executor, number_of_passes_, std::uint64_t(0)))
      , control_(filled(executor, 1, Field_control()))
      , meetings_(executor.template make<Meeting>(sides.crossings.size() + 256))
      , numbers_of_walks_(filled(executor, number_of_passes_, Index(0)))
      , walks_(filled(executor, number_of_passes_ * wanted_walks, Found_walk{no_index, 0, 0, 0}))
      , walk_vertices_(executor.template make<Index>(
            room.walk_size * wanted_walks * (sides.crossings.size() + 16 * number_of_passes_)))
      , walk_counters_(filled(executor, 1, Walk_counters()))
      , field_{Domain(mesh,
                      walls,
                      {directory_.span(),
                       static_cast<Index>(rows_per_pass(mesh.number_of_vertices())), pages_.span(),
                       number_of_pages_.span().data(), loops_.span(), is_starved_.span()}),
               {{values_[0].span(), values_[1].span()},
                time_.span(),
                state_.span(),
                {bands_[0].span(), bands_[1].span()},
                reached_.span(),
                back_.span(),
                {{progress_[0].span(), progress_[1].span()},
                 last_step_.span(),
                 {band_changes_[0].span(), band_changes_[1].span(), band_changes_[2].span()},
                 band_sizes_.span(),
                 updates_.span(),
                 number_of_updates},
                control_.span().data()}} {}

  /// runs the passes until nothing is left to find. Returns false if the callback says so.
  bool run(const Step_coefficients& k, const Tuning& tuning, const Callback& callback) {
    start();
    close_walks();
    while(seen_.state.next_list_size != 0) {
      if(!callback(0.))
        return false;
      const Time now = seen_.state.step;
      executor_.run(
          Field_steps<Domain>(field_, k,
                              {no_index, now + (std::min)(tuning.steps_per_look, k.patience),
                               now + tuning.steps_per_look_if_met}),
          number_of_passes_ + seen_.state.next_list_size);
      look_at_reached();
      close_walks();
    }
    return true;
  }

  std::vector<std::uint32_t> are_starved() { return downloaded(executor_, is_starved_); }

  /// what was found by each of the passes that are not starved.
  std::vector<Dual_walks> found() {
    const Walk_counters counters = downloaded(executor_, walk_counters_)[0];
    if(counters.lost != 0)
      throw Device_exception("the path back from a merge of two fronts is lost");
    std::vector<Found_walk> walks((std::min<std::size_t>)(counters.walks, walks_.span().size()));
    std::vector<Index> vertices(
        (std::min<std::size_t>)(counters.vertices, walk_vertices_.span().size()));
    executor_.download(walks.data(), Span<Found_walk>(walks_.span().data(), walks.size()));
    executor_.download(vertices.data(), Span<Index>(walk_vertices_.span().data(), vertices.size()));
    std::sort(walks.begin(), walks.end(), [](const Found_walk& a, const Found_walk& b) {
      return std::tie(a.pass, a.rank) < std::tie(b.pass, b.rank);
    });
    std::vector<Dual_walks> found(number_of_passes_);
    for(const Found_walk& walk : walks) {
      if(walk.pass == no_index)
        break; // for the vertices of which there was no room
      const auto begin = vertices.begin() + walk.begin;
      found[walk.pass].walks.emplace_back(begin, begin + walk.size);
      remove_spurs(found[walk.pass].walks.back());
    }
    const std::vector<std::uint64_t> updates = downloaded(executor_, updates_);
    for(std::size_t i = 0; i < found.size(); ++i)
      found[i].has_given_up = updates[i] >= field_.arrays.passes.enough_updates;
    return found;
  }

  const Field_control& control() const { return seen_; }

private:
  static std::size_t cells(const Room& room) { return room.number_of_pages * page_size; }
  static std::size_t rows_per_pass(std::size_t number_of_vertices) {
    return (number_of_vertices + page_size - 1) / page_size;
  }

  Loop_sides sides() const {
    return {crossings_.span(), pass_.span(), begin_.span(), along_.span()};
  }

  Meeting_list meeting_list() const {
    return {meetings_.span(), &control_.span().data()->number_of_meetings};
  }

  void start() {
    using Round = typename Start_passes<Domain>::Round;
    const auto make = [&](Round round) {
      executor_.for_each(crossings_.span().size(),
                         Start_passes<Domain>{field_, sides(), meeting_list(), round});
    };
    make(Round::LEFT);
    make(Round::RIGHT);
    make(Round::BAND);
    note([&] {
      make(Round::RIGHT_AGAIN);
      make(Round::MEETINGS);
    });
    seen_.state.next_list_size = seen_.counters.added[0].value;
  }

  void look() { executor_.download(&seen_, control_.span()); }

  void look_at_reached() {
    Index& reached = control_.span().data()->counters.reached.value;
    note([&] {
      executor_.for_each_of(&reached, reached_.span().size(),
                            Look_at_reached<Domain>{field_, meeting_list()});
    });
    clear(reached);
  }

  // Calls `f`, which notes meetings, once more if there was no room for all of them.
  template <typename Function> void note(const Function& f) {
    f();
    look();
    if(seen_.number_of_meetings <= meetings_.span().size())
      return;
    meetings_ = Buffer<Meeting>();
    meetings_ = executor_.template make<Meeting>(seen_.number_of_meetings);
    clear(control_.span().data()->number_of_meetings);
    f();
    look();
  }

  void clear(Index& number) { executor_.fill(Span<Index>(&number, 1), Index(0)); }

  void close_walks() {
    if(seen_.number_of_meetings == 0)
      return;
    const Buffer<Index> begins = uploaded(executor_, sort_meetings());
    const Walk_list out = {walks_.span(), walk_vertices_.span(), walk_counters_.span().data()};
    executor_.for_each(number_of_passes_,
                       Close_walks<Domain>{field_, sides(), meetings_.span(), begins.span(),
                                           numbers_of_walks_.span(), wanted_walks_, out});
    clear(control_.span().data()->number_of_meetings);
  }

  // Returns where the meetings of each pass begin.
  std::vector<Index> sort_meetings() {
    std::vector<Meeting> meetings(seen_.number_of_meetings);
    const Span<Meeting> on_device(meetings_.span().data(), meetings.size());
    executor_.download(meetings.data(), on_device);
    std::sort(meetings.begin(), meetings.end());
    executor_.upload(on_device, meetings.data());
    std::vector<Index> sizes(number_of_passes_, 0);
    for(const Meeting& meeting : meetings)
      ++sizes[meeting.pass];
    return begins_of(sizes);
  }

  Executor& executor_;
  Index wanted_walks_;
  std::size_t number_of_passes_;
  Buffer<Crossing> crossings_;
  Buffer<Index> pass_, begin_;
  Buffer<double> along_;
  Buffer<Index> loops_;
  Buffer<Index> directory_;
  Buffer<Page> pages_;
  Buffer<Index> number_of_pages_;
  Buffer<std::uint32_t> is_starved_;
  Buffer<float> values_[2];
  Buffer<Time> time_;
  Buffer<std::uint32_t> state_;
  Buffer<Banded_cell> bands_[2];
  Buffer<Index> reached_, back_;
  Buffer<Time> progress_[2], last_step_;
  Buffer<Index> band_changes_[3], band_sizes_;
  Buffer<std::uint64_t> updates_;
  Buffer<Field_control> control_;
  Buffer<Meeting> meetings_;
  Buffer<Index> numbers_of_walks_;
  Buffer<Found_walk> walks_;
  Buffer<Index> walk_vertices_;
  Buffer<Walk_counters> walk_counters_;
  Field<Domain> field_;
  Field_control seen_;
};

/*!
The loop passes of one search. As many run at a time as the free memory has room for: all of them as
long as it suffices; passes that find no room begin again, in a larger table if there is memory for
one, else fewer at a time. The answer does not depend on that.
*/
template <typename Executor, typename Loop_set> class Device_search
{
  using Batch = Search_batch<Executor, Loop_set>;
  using Room = typename Batch::Room;

public:
  Device_search(Executor& executor,
                const Device_mesh<Executor>& mesh,
                const Flat_mesh& host_mesh,
                const Tuning& tuning,
                Costs& costs)
      : executor_(executor)
      , mesh_(mesh)
      , host_mesh_(host_mesh)
      , tuning_(tuning)
      , costs_(costs) {}

  std::vector<Dual_walks>
  run(const Dual_loop_query& search, const Step_coefficients& k, const Callback& callback) {
    const auto begins = uploaded(executor_, search.index.begins_of_all());
    const auto entries = uploaded(executor_, search.index.entries());
    const Wall_arrays<Loop_set> walls = {begins.span(), entries.span()};
    const std::size_t number = search.numbers.size();
    std::vector<Dual_walks> found(number);
    std::vector<Index> pending(number); // positions in the list of numbers
    std::iota(pending.begin(), pending.end(), Index(0));
    std::size_t in_flight = first_in_flight(number);
    Room room = first_room(in_flight);
    while(!pending.empty()) {
      const std::size_t size = (std::min)(in_flight, pending.size());
      const std::vector<Index> now(pending.begin(), pending.begin() + size);
      pending.erase(pending.begin(), pending.begin() + size);
      try {
        const std::vector<Index> starved = run_batch(search, walls, now, room, k, callback, found);
        if(!starved.empty())
          make_room(room, in_flight, size);
        pending.insert(pending.begin(), starved.begin(), starved.end());
      } catch(const Out_of_device_memory_exception&) {
        const std::size_t one = pages_of_one_pass(mesh_.number_of_vertices());
        if(size == 1 && room.number_of_pages <= one)
          throw;
        in_flight = (std::max)(std::size_t(1), size / 2);
        room.number_of_pages = (std::min)(room.number_of_pages, in_flight * one);
        pending.insert(pending.begin(), now.begin(), now.end());
      }
      if(!callback(1. - double(pending.size()) / double(number)))
        throw Interrupted_exception();
    }
    return found;
  }

  /// the bytes that are needed beside the mesh to run at least one pass at a time, wherever it
  /// goes.
  static std::size_t bytes(std::size_t number_of_vertices) {
    return pages_of_one_pass(number_of_vertices) * Batch::bytes_per_page +
           Batch::bytes_per_pass(number_of_vertices) + number_of_vertices * sizeof(Index) +
           2 * reserve(number_of_vertices);
  }

private:
  static std::size_t pages_of_one_pass(std::size_t number_of_vertices) {
    return number_of_vertices / Batch::page_size + 1;
  }

  // What is left to all that is not in proportion to the pages.
  static std::size_t reserve(std::size_t number_of_vertices) {
    return (std::size_t(1) << 19) + 16 * number_of_vertices;
  }

  // The directories of the passes may take a quarter of the memory.
  std::size_t first_in_flight(std::size_t number_of_passes) const {
    const std::size_t most =
        executor_.free_bytes() / 4 / Batch::bytes_per_pass(mesh_.number_of_vertices());
    return (std::max)(std::size_t(1), (std::min)(most, number_of_passes));
  }

  // The pages that there is memory for beside so many passes. Cells are numbered by 32 bits.
  std::size_t most_pages(std::size_t in_flight) const {
    const std::size_t n = mesh_.number_of_vertices(), free = executor_.free_bytes();
    const std::size_t taken = reserve(n) + in_flight * Batch::bytes_per_pass(n);
    return (std::min)((free - (std::min)(free, taken)) / Batch::bytes_per_page,
                      std::size_t(no_index / Batch::page_size));
  }

  // At first the passes may cover the mesh eight times over, as far as the memory allows; a few
  // passes cannot cover it more often than there are passes.
  Room first_room(std::size_t in_flight) const {
    const std::size_t covers = (std::min)(in_flight, std::size_t(8));
    const std::size_t pages =
        covers * pages_of_one_pass(mesh_.number_of_vertices()) + 16 * in_flight;
    return {(std::min)(pages, most_pages(in_flight)), 2};
  }

  // After a batch in which some passes found no room: for their pages, or for their walks.
  void make_room(Room& room, std::size_t& in_flight, std::size_t tried) const {
    const std::size_t pages = (std::min)(2 * room.number_of_pages, most_pages(tried));
    if(pages <= room.number_of_pages && tried == 1 && room.walk_size > mesh_.number_of_vertices())
      throw Out_of_device_memory_exception(2 * room.number_of_pages * Batch::bytes_per_page,
                                           executor_.free_bytes());
    room.walk_size *= 2;
    if(pages > room.number_of_pages)
      room.number_of_pages = pages;
    else
      in_flight = (std::max)(std::size_t(1), tried / 2);
  }

  // Fills in what is found for some of the numbers, and returns those that found no room.
  std::vector<Index> run_batch(const Dual_loop_query& search,
                               const Wall_arrays<Loop_set>& walls,
                               const std::vector<Index>& positions,
                               const Room& room,
                               const Step_coefficients& k,
                               const Callback& callback,
                               std::vector<Dual_walks>& found) {
    std::vector<Index> loops;
    for(Index position : positions)
      loops.push_back(search.numbers[position]);
    Batch batch(executor_, mesh_.view(), walls, sides_of(host_mesh_, search, loops),
                search.number_of_walks, search.number_of_updates, room);
    costs_.largest_bytes = (std::max)(costs_.largest_bytes, executor_.bytes_in_use());
    costs_.largest_batch = (std::max)(costs_.largest_batch, loops.size());
    ++costs_.number_of_batches;
    if(!batch.run(k, tuning_, callback))
      throw Interrupted_exception();
    costs_.number_of_updates += batch.control().state.number_of_updates;
    costs_.number_of_steps += batch.control().state.step;
    const std::vector<std::uint32_t> are_starved = batch.are_starved();
    std::vector<Dual_walks> now = batch.found();
    std::vector<Index> starved;
    for(std::size_t i = 0; i < positions.size(); ++i)
      if(are_starved[i] != 0)
        starved.push_back(positions[i]);
      else
        found[positions[i]] = std::move(now[i]);
    return starved;
  }

  Executor& executor_;
  const Device_mesh<Executor>& mesh_;
  const Flat_mesh& host_mesh_;
  Tuning tuning_;
  Costs& costs_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SEARCH_H
