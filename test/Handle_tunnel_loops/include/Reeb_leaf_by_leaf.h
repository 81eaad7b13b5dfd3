#ifndef HTL_TEST_REEB_LEAF_BY_LEAF_H
#define HTL_TEST_REEB_LEAF_BY_LEAF_H

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// The simplification of a Reeb graph by its definition: again and again the smallest leaf is looked
// for among all, and everything about it is added up anew from the arcs of the graph.

namespace reeb_leaf_by_leaf {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Reeb_measure;

// An arc of the graph, and whether it is passed downwards.
struct Piece
{
  Index arc;
  bool is_reversed;
};

struct Path
{
  Index lower, upper; // nodes
  std::vector<Piece> pieces;
  std::vector<Index> arcs; // the pieces, and the arcs of leaves that were taken off from them
};

class Leaf_by_leaf
{
public:
  Leaf_by_leaf(const Flat_mesh& mesh,
               const Flat_reeb_graph& graph,
               const std::vector<double>& values,
               Reeb_measure measure,
               double threshold)
      : mesh_(mesh)
      , graph_(graph)
      , values_(values)
      , measure_(measure)
      , limit_(threshold * size_of_surface()) {
    for(Index a = 0; a < graph.arcs.size(); ++a)
      paths_.push_back({graph.arcs[a].lower, graph.arcs[a].upper, {{a, false}}, {a}});
    while(take_off_smallest_leaf())
      ;
  }

  // In the order in which they were made.
  const std::vector<Path>& paths() const { return paths_; }

  // The lower node, all means, the upper node.
  std::vector<Vector> line(const Path& path) const {
    std::vector<Vector> line = {graph_.nodes[path.lower].position};
    const std::vector<Vector> all = means(path);
    line.insert(line.end(), all.begin(), all.end());
    line.push_back(graph_.nodes[path.upper].position);
    return line;
  }

  bool is_leaf(const Path& path) const {
    return is_extremum(path.lower) != is_extremum(path.upper);
  }

private:
  static constexpr double slenderness_of_limbs = 0.8;

  bool is_extremum(Index node) const { return graph_.nodes[node].kind != Node_kind::SADDLE; }

  Index saddle_of(const Path& leaf) const {
    return is_extremum(leaf.lower) ? leaf.upper : leaf.lower;
  }

  // The other two that end at the saddle of a leaf; one twice if it begins and ends there.
  std::vector<std::size_t> others_at(Index saddle, std::size_t leaf) const {
    std::vector<std::size_t> others;
    for(std::size_t i = 0; i < paths_.size(); ++i)
      if(i != leaf) {
        if(paths_[i].lower == saddle)
          others.push_back(i);
        if(paths_[i].upper == saddle)
          others.push_back(i);
      }
    return others;
  }

  bool take_off_smallest_leaf() {
    std::size_t smallest = paths_.size();
    for(std::size_t i = 0; i < paths_.size(); ++i)
      if(is_leaf(paths_[i]) && is_small(paths_[i]) &&
         (smallest == paths_.size() || size(paths_[i]) < size(paths_[smallest])))
      {
        const auto others = others_at(saddle_of(paths_[i]), i);
        if(others[0] != others[1])
          smallest = i;
      }
    if(smallest == paths_.size())
      return false;
    take_off(smallest);
    return true;
  }

  void take_off(std::size_t leaf) {
    const Index saddle = saddle_of(paths_[leaf]);
    const auto others = others_at(saddle, leaf);
    Path first = paths_[others[0]], second = paths_[others[1]];
    if(first.upper != saddle)
      reverse(first);
    if(second.lower != saddle)
      reverse(second);
    Path joined = {first.lower, second.upper, first.pieces, first.arcs};
    joined.pieces.insert(joined.pieces.end(), second.pieces.begin(), second.pieces.end());
    joined.arcs.insert(joined.arcs.end(), second.arcs.begin(), second.arcs.end());
    joined.arcs.insert(joined.arcs.end(), paths_[leaf].arcs.begin(), paths_[leaf].arcs.end());
    if(joined.lower > joined.upper)
      reverse(joined);
    std::vector<std::size_t> gone = {leaf, others[0], others[1]};
    std::sort(gone.rbegin(), gone.rend());
    for(const std::size_t i : gone)
      paths_.erase(paths_.begin() + static_cast<std::ptrdiff_t>(i));
    paths_.push_back(joined);
  }

  static void reverse(Path& path) {
    std::swap(path.lower, path.upper);
    std::reverse(path.pieces.begin(), path.pieces.end());
    for(Piece& piece : path.pieces)
      piece.is_reversed = !piece.is_reversed;
  }

  // ---- how large a leaf is

  bool is_small(const Path& leaf) const {
    return size(leaf) <= limit_ ||
           (measure_ == Reeb_measure::LIMBS && slenderness(leaf) < slenderness_of_limbs);
  }

  double size(const Path& path) const {
    switch(measure_) {
    case Reeb_measure::LENGTH:
      return length(path);
    case Reeb_measure::AREA:
    case Reeb_measure::VERTICES:
      return amount(path);
    default:
      return range(path);
    }
  }

  double range(const Path& path) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for(const Piece& piece : path.pieces)
      for(const Index node : {graph_.arcs[piece.arc].lower, graph_.arcs[piece.arc].upper}) {
        low = (std::min)(low, values_[graph_.nodes[node].vertex]);
        high = (std::max)(high, values_[graph_.nodes[node].vertex]);
      }
    return high - low;
  }

  // Vertices, or the faces of which they are the first ones.
  double amount(const Path& path) const {
    double sum = 0.;
    for(Index v = 0; v < graph_.vertex_arc.size(); ++v)
      if(std::find(path.arcs.begin(), path.arcs.end(), graph_.vertex_arc[v]) != path.arcs.end())
        sum += amount_at(v);
    return sum;
  }

  double amount_at(Index v) const {
    if(measure_ == Reeb_measure::VERTICES)
      return 1.;
    double sum = 0.;
    for(const Index u : mesh_.ring(v)) {
      const Index w = mesh_.ring(v).after(u);
      if(v < u && v < w)
        sum += norm(cross(mesh_.points[u] - mesh_.points[v], mesh_.points[w] - mesh_.points[v]));
    }
    return sum;
  }

  // From the first to the last mean, or from an extremum.
  double length(const Path& path) const {
    std::vector<Vector> line = means(path);
    if(graph_.nodes[path.lower].kind != Node_kind::SADDLE)
      line.insert(line.begin(), graph_.nodes[path.lower].position);
    if(graph_.nodes[path.upper].kind != Node_kind::SADDLE)
      line.push_back(graph_.nodes[path.upper].position);
    double sum = 0.;
    for(std::size_t i = 1; i < line.size(); ++i)
      sum += norm(line[i] - line[i - 1]);
    return sum;
  }

  std::vector<Vector> means(const Path& path) const {
    std::vector<Vector> all;
    for(const Piece& piece : path.pieces) {
      std::vector<Vector> part;
      for(const auto& sample : graph_.samples)
        if(sample.arc == piece.arc)
          part.push_back(to_vector(sample.position));
      if(piece.is_reversed)
        std::reverse(part.begin(), part.end());
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  double slenderness(const Path& leaf) const {
    const bool is_above = is_extremum(leaf.lower);
    const Piece& base = is_above ? leaf.pieces.back() : leaf.pieces.front();
    const auto& arc = graph_.arcs[base.arc];
    const double girth = base.is_reversed == is_above ? arc.lower_girth : arc.upper_girth;
    constexpr double circle = 6.28318530717958648;
    return girth > 0. ? circle * length(leaf) / girth : std::numeric_limits<double>::infinity();
  }

  // Of a connected surface.
  double size_of_surface() const {
    Vector low = mesh_.points[0], high = low;
    double sum = 0.;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      sum += amount_at(v);
      for(int d = 0; d < 3; ++d) {
        low[d] = (std::min)(low[d], mesh_.points[v][d]);
        high[d] = (std::max)(high[d], mesh_.points[v][d]);
      }
    }
    const auto [lowest, highest] = std::minmax_element(values_.begin(), values_.end());
    return measure_ == Reeb_measure::LENGTH ? norm(high - low)
           : measure_ == Reeb_measure::AREA || measure_ == Reeb_measure::VERTICES
               ? sum
               : *highest - *lowest;
  }

  const Flat_mesh& mesh_;
  const Flat_reeb_graph& graph_;
  const std::vector<double>& values_;
  Reeb_measure measure_;
  double limit_;
  std::vector<Path> paths_;
};

} // namespace reeb_leaf_by_leaf

#endif // HTL_TEST_REEB_LEAF_BY_LEAF_H
