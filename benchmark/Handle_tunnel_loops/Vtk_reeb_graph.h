#ifndef BENCHMARK_VTK_REEB_GRAPH_H
#define BENCHMARK_VTK_REEB_GRAPH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// What VTK's filter took and found, in a process of its own.
struct Vtk_result
{
  bool is_done = false; ///< otherwise it ran out of time or memory
  double seconds = 0.;
  double bytes = 0.; ///< the peak beyond the mesh and the function
  long long nodes = 0, arcs = 0;
};

/// runs vtkPolyDataToReebGraphFilter for at most `limit` seconds.
Vtk_result vtk_reeb_graph(const std::vector<std::array<double, 3>>& points,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles,
                          const std::vector<double>& function,
                          unsigned limit);

#endif // BENCHMARK_VTK_REEB_GRAPH_H
