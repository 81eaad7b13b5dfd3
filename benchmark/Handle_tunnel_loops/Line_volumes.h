// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_LINE_VOLUMES_H
#define BENCHMARK_LINE_VOLUMES_H

#include "Judged_faces.h"

#include <map>

/// \file Line_volumes.h
/// What was taken of a solid and what was added to it, where both happen.

namespace judge {

/// A face that came or went.
struct Sheet
{
  Triangle corners;
  bool is_new;
  std::size_t owner; ///< the handle for which it came, or nobody
};

struct Volumes
{
  double added = 0., taken = 0.;
};

/// Volumes between old and new faces, along parallel lines in three directions. Along a line it is
/// counted how many times more often a point is inside after the change: what is crossed is decided
/// by exact predicates. Each stretch is of the handle whose new face ends it.
class Line_volumes
{
public:
  /// Faces point outwards. Stretches that are not longer than \p least_length are none.
  Line_volumes(const std::vector<Sheet>& sheets, double least_length)
      : sheets_(sheets)
      , least_length_(least_length)
      , number_of_rows_(std::clamp(int(3. * std::sqrt(double(sheets.size()))), 64, 512)) {
    // as oblique to axes and diagonals as any
    for(const Vector& direction : {Vector(0.6180, 0.2963, 0.7282), Vector(-0.2718, 0.8414, 0.4672),
                                   Vector(0.7548, -0.5698, 0.3247)})
      add(direction / length_of(direction));
  }

  const std::map<std::size_t, Volumes>& volumes() const { return volumes_; }

private:
  using Point_2 = Kernel::Point_2;

  struct Crossing
  {
    int column;
    double along; // the line
    int step;     // by how many times more often inside
    std::size_t owner;

    bool operator<(const Crossing& other) const {
      return column != other.column ? column < other.column : along < other.along;
    }
  };

  struct Seen_sheet
  {
    std::array<Point_2, 3> corners;
    std::array<double, 3> along;
    int step;
    std::size_t owner;
  };

  void add(const Vector& direction) {
    const Vector side = CGAL::cross_product(direction, Vector(0.31, 0.59, -0.74));
    const Vector u = side / length_of(side), v = CGAL::cross_product(direction, u);
    const Point origin = sheets_.front().corners[0];
    std::vector<Seen_sheet> seen;
    CGAL::Bbox_2 box;
    for(const Sheet& sheet : sheets_) {
      seen.push_back(seen_sheet(sheet, origin, {u, v, direction}));
      for(const Point_2& p : seen.back().corners)
        box += p.bbox();
    }
    lines_of(seen, box);
  }

  static Seen_sheet
  seen_sheet(const Sheet& sheet, const Point& origin, const std::array<Vector, 3>& axes) {
    Seen_sheet seen;
    for(std::size_t i = 0; i < 3; ++i) {
      const Vector p = sheet.corners[i] - origin;
      seen.corners[i] = Point_2(p * axes[0], p * axes[1]);
      seen.along[i] = p * axes[2];
    }
    // A face that is seen counterclockwise against the lines points with them: solid ends there.
    const auto turn = CGAL::orientation(seen.corners[0], seen.corners[1], seen.corners[2]);
    seen.step = (sheet.is_new ? -1 : 1) * int(turn);
    seen.owner = sheet.owner;
    return seen;
  }

  void lines_of(const std::vector<Seen_sheet>& seen, const CGAL::Bbox_2& box) {
    width_ = (box.xmax() - box.xmin()) / number_of_rows_;
    height_ = (box.ymax() - box.ymin()) / number_of_rows_;
    std::vector<std::vector<Crossing>> rows{std::size_t(number_of_rows_)};
    for(const Seen_sheet& sheet : seen)
      if(sheet.step != 0)
        cross(sheet, box, rows);
    for(std::vector<Crossing>& row : rows) {
      std::sort(row.begin(), row.end());
      add_stretches(row);
    }
  }

  // Rows are shifted against each other, so that no two lines are in line with an edge of a box.
  Point_2 line(int row, int column, const CGAL::Bbox_2& box) const {
    const double shift = std::fmod(0.5 + row * 0.6180339887498949, 1.);
    return {box.xmin() + (column + shift) * width_, box.ymin() + (row + 0.5) * height_};
  }

  void cross(const Seen_sheet& sheet,
             const CGAL::Bbox_2& box,
             std::vector<std::vector<Crossing>>& rows) const {
    CGAL::Bbox_2 own;
    for(const Point_2& p : sheet.corners)
      own += p.bbox();
    const auto place = [this](double x, double size) {
      return std::clamp(int(std::floor(x / size)), -1, number_of_rows_);
    };
    const int first = (std::max)(0, place(own.ymin() - box.ymin(), height_) - 1);
    const int last = (std::min)(number_of_rows_ - 1, place(own.ymax() - box.ymin(), height_) + 1);
    const int left = (std::max)(0, place(own.xmin() - box.xmin(), width_) - 1);
    const int right = (std::min)(number_of_rows_ - 1, place(own.xmax() - box.xmin(), width_) + 1);
    for(int row = first; row <= last; ++row)
      for(int column = left; column <= right; ++column) {
        const Point_2 p = line(row, column, box);
        if(is_inside(p, sheet.corners))
          rows[std::size_t(row)].push_back({column, along(p, sheet), sheet.step, sheet.owner});
      }
  }

  static bool is_inside(const Point_2& p, const std::array<Point_2, 3>& t) {
    const auto a = CGAL::orientation(t[0], t[1], p);
    return a != CGAL::COLLINEAR && CGAL::orientation(t[1], t[2], p) == a &&
           CGAL::orientation(t[2], t[0], p) == a;
  }

  static double along(const Point_2& p, const Seen_sheet& sheet) {
    const auto& t = sheet.corners;
    const double a = CGAL::area(p, t[1], t[2]), b = CGAL::area(t[0], p, t[2]),
                 c = CGAL::area(t[0], t[1], p);
    return (a * sheet.along[0] + b * sheet.along[1] + c * sheet.along[2]) / (a + b + c);
  }

  void add_stretches(const std::vector<Crossing>& row) {
    int depth = 0;
    for(std::size_t i = 0; i + 1 < row.size(); ++i) {
      if(i > 0 && row[i].column != row[i - 1].column)
        depth = 0;
      depth += row[i].step;
      const Crossing &from = row[i], &to = row[i + 1];
      if(depth == 0 || from.column != to.column || to.along - from.along <= least_length_)
        continue;
      const double volume = width_ * height_ * (to.along - from.along) * std::abs(depth) / 3.;
      Volumes& of = volumes_[from.owner != nobody ? from.owner : to.owner];
      (depth > 0 ? of.added : of.taken) += volume;
    }
  }

  const std::vector<Sheet>& sheets_;
  const double least_length_;
  const int number_of_rows_;
  double width_ = 0., height_ = 0.; // of what a line stands for
  std::map<std::size_t, Volumes> volumes_;
};

} // namespace judge

#endif // BENCHMARK_LINE_VOLUMES_H
