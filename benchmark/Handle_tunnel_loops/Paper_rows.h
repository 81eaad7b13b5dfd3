#ifndef BENCHMARK_PAPER_ROWS_H
#define BENCHMARK_PAPER_ROWS_H

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Paper_rows.h
/// The two tables of the paper, and what is computed beside each row.

namespace paper {

constexpr double unknown = -1.; ///< did not finish, crashed, or is not told

struct Row
{
  std::string mesh;
  std::size_t faces, genus;
  double total, initial, tunnel, handle; ///< seconds, on an RTX 2080 Ti
  double others_total;                   ///< seconds of Dey, Fan and Wang 2013, on a Core i7-7700
  double initial_megabytes;              ///< on the device, in the initial pass
  double passes_megabytes;               ///< ... in the passes after it, of several handles at once
  double others_megabytes;               ///< of Dey, Fan and Wang 2013
  double length_ratio;                   ///< of the paper's loops to those of Dey, Fan and Wang
  std::string kind; ///< of the generated mesh that has as many faces and, at least, handles
};

/*!
Tables 1 and 2 of the paper. Their meshes are not ours to give away, so a generated one stands for
each, with as many faces, at least as many handles (the noise of a scan makes some more), and
triangles of the same sort:

- `scan`: a smooth body, evenly triangulated, with small handles from noise: for the statues,
  dragons and figures, which come from scanners (MotherWithChild, Happy Buddha, Dragon Phoenix,
  Dancing children, Dragon Ball, Napoleon, Statue);
- `multi-torus`: a smooth thick slab with holes, evenly triangulated: for smooth bodies with a few
  large handles (Double Torus, Botijo);
- `sponge`: flat faces and sharp edges, evenly triangulated: for things that were made by machines,
  with bores (Casting, Metal Key, Drill); `lattice`: regular struts (Ball, Metal Table); `gyroid`:
thick pipes (Grayloc); `foam`: struts at random (V745 Sco nova, and Dragon Tamer, with more handles
than scans can have); `chair`: the chair.

Triangulations that are harder than those of the paper have rows of their own: `hard_rows()`.
*/
inline std::vector<Row> rows() {
  constexpr double x = unknown;
  return {
      {"Torus", 3100, 1, 0.16, 0.12, 0.00, 0.00, 0.02, 86, 2, 10, 1.005, "torus"},
      {"Double Torus", 25000, 2, 0.48, 0.42, 0.00, 0.00, 0.18, 92, 6, 42, 1.010, "multi-torus"},
      {"MotherWithChild", 28000, 4, 0.42, 0.29, 0.08, 0.04, 0.52, 92, 18, 76, 0.988, "scan"},
      {"Botijo", 82000, 5, 1.78, 0.65, 0.72, 0.41, 1.81, 108, 108, 193, 0.960, "multi-torus"},
      {"Casting", 93000, 9, 1.31, 0.70, 0.30, 0.30, 3.10, 114, 134, 210, 0.999, "sponge"},
      {"Happy Buddha", 98000, 8, 1.13, 0.61, 0.28, 0.24, 2.04, 97, 112, 189, 0.988, "scan"},
      {"Ball", 184000, 120, 17.65, 13.01, 1.97, 1.16, 401.77, 152, 458, 2135, 0.918, "lattice"},
      {"Metal Key", 390000, 10, 10.48, 6.87, 2.11, 1.50, 36.52, 210, 552, 810, 0.984, "sponge"},
      {"Wooden Chair", 400000, 7, 7.49, 4.45, 2.28, 0.77, 31.21, 214, 472, 921, 0.982, "chair"},
      {"Dragon Phoenix", 750000, 11, 12.89, 8.75, 2.15, 1.99, 100.83, 340, 1062, 1540, 0.942,
       "scan"},
      {"Grayloc", 921000, 5, 22.25, 14.23, 4.11, 3.92, x, 366, 1155, x, x, "gyroid"},
      {"V745 Sco nova", 923000, 184, 273.99, 104.21, 86.32, 82.34, x, 502, 1402, x, x, "foam"},
      {"Metal Table", 950000, 198, 151.33, 92.31, 36.02, 21.32, 3732.92, 336, 882, 16891, 0.954,
       "lattice"},
      {"Dancing children", 1300000, 8, 20.57, 13.29, 4.01, 3.13, 102.54, 462, 612, 4992, 0.989,
       "scan"},
      {"Drill", 1500000, 13, 18.77, 13.92, 2.67, 2.18, 90.32, 496, 1844, 4142, 0.846, "sponge"},
      {"Dragon Tamer", 2000000, 335, 429.57, 254.93, 93.90, 78.63, x, 636, 1410, x, x, "foam"},
      {"Dragon Ball", 2400000, 5, 37.29, 21.88, 9.40, 6.01, 91.70, 728, 1452, 4557, 0.975, "scan"},
      {"Napoleon", 6500000, 25, 705.34, 376.50, 170.86, 157.99, x, 1844, 7744, x, x, "scan"},
      {"Statue", 10000000, 3, 167.71, 152.18, 7.41, 8.12, 491.69, 496, 1844, 4142, 0.976, "scan"}};
}

/// rows of the tables once more, with triangulations that are harder than those of the paper:
/// `foam`, of struts that are thin and rough, and `plates`, of few, long and thin triangles with
/// vertices that have thousands of neighbours.
inline std::vector<Row> hard_rows() {
  const std::vector<std::pair<std::string, std::string>> kinds = {{"MotherWithChild", "foam"},
                                                                  {"Botijo", "foam"},
                                                                  {"Casting", "plates"},
                                                                  {"Metal Key", "plates"},
                                                                  {"Drill", "plates"}};
  std::vector<Row> hard;
  for(Row& row : rows())
    for(const auto& [mesh, kind] : kinds)
      if(row.mesh == mesh) {
        row.kind = kind;
        hard.push_back(row);
      }
  return hard;
}

} // namespace paper

#endif // BENCHMARK_PAPER_ROWS_H
