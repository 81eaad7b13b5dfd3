#ifndef BENCHMARK_STAGES_OF_LOOPS_H
#define BENCHMARK_STAGES_OF_LOOPS_H

#include "Benchmark_meshes.h"

#include <CGAL/handle_tunnel_loops.h>

#include <cstddef>
#include <cstdio>
#include <iterator>
#include <vector>

/// \file Stages_of_loops.h
/// The whole computation of loops, and the columns of a table that has its stages.

namespace HTL = CGAL::Handle_tunnel_loops;

/// All stages but the last, which is of Reeb graphs.
constexpr std::size_t number_of_stages_of_loops = static_cast<std::size_t>(HTL::Stage::DIFFUSION);

template <typename ConcurrencyTag = CGAL::Sequential_tag>
HTL::Statistics find_loops(const Mesh& mesh) {
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(ConcurrencyTag(), mesh,
                                                CGAL::parameters::default_values());
  solver.find_loops<ConcurrencyTag>(std::back_inserter(pairs));
  return solver.statistics();
}

/// goes on with the head of a table: the stages, after so many columns, and the line below it.
inline void print_stages_of_head(std::size_t columns_before) {
  for(std::size_t i = 0; i < number_of_stages_of_loops; ++i)
    std::printf(" %s |", HTL::stage_name(static_cast<HTL::Stage>(i)));
  std::printf("\n|");
  for(std::size_t i = 0; i < columns_before + number_of_stages_of_loops; ++i)
    std::printf("---|");
  std::printf("\n");
}

#endif // BENCHMARK_STAGES_OF_LOOPS_H
