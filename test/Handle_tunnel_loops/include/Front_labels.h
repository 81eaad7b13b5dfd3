#ifndef HTL_TEST_FRONT_LABELS_H
#define HTL_TEST_FRONT_LABELS_H

#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

namespace front_labels {

using namespace CGAL::Handle_tunnel_loops::internal;

/*
The connected components of a front: of the triangles that the isoline of the arrival times at one
level passes, adjacent across the edges that it passes. They are simple closed curves.

Of the corners of such a triangle one lies alone on its side of the level; the place of the triangle
in the ring of that corner is the number of the triangle, and in the end its label is the smallest
number of its component. The labels are found after Soman, Kothapalli and Narayanan (2010): each
pair of neighbours hooks the larger of its two roots to the smaller, then all pointers jump to their
roots, until no pair has two roots.
*/
class Front
{
public:
  Front(const Mesh_view& mesh, const Span<const Time>& time, Time level)
      : mesh_(mesh)
      , time_(time)
      , level_(level) {}

  CGAL_HTL_HOST_DEVICE bool is_behind(Index v) const { return time_[v] <= level_; }

  // whether position `i` in the ring of `v` is the number of a triangle of the front.
  CGAL_HTL_HOST_DEVICE bool is_front(Index v, Index i) const {
    const Ring ring = mesh_.ring(v);
    return is_behind(ring[i]) != is_behind(v) && is_behind(ring[ring.next(i)]) != is_behind(v);
  }

  // the number of the front's next triangle, with what is behind on the left.
  CGAL_HTL_HOST_DEVICE Index next(Index v, Index i) const {
    const Ring ring = mesh_.ring(v);
    const bool is_left = is_behind(v);
    const Index j = is_left ? ring.next(i) : ring.previous(i);
    const Index through = ring[is_left ? j : i], apex = ring[is_left ? ring.next(j) : j];
    if(is_behind(apex) != is_left)
      return mesh_.row_begin[v] + j;
    return mesh_.row_begin[through] + mesh_.ring(through).position(is_left ? apex : v);
  }

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }

private:
  Mesh_view mesh_;
  Span<const Time> time_;
  Time level_;
};

// A triangle of the front and its next one.
struct Front_pair
{
  Index triangle, neighbor;
};

// Lists the triangles of the front, each with its next one, and makes each its own label.
struct Collect_front
{
  Front front;
  Span<Index> label; // by position in the rings
  Span<Front_pair> pairs;
  Index* number_of_pairs;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    const Index begin = front.mesh().row_begin[v];
    for(Index i = 0; i < front.mesh().ring(v).size(); ++i) {
      label[begin + i] = no_index;
      if(!front.is_front(v, i))
        continue;
      label[begin + i] = begin + i;
      const Index place = next_place(*number_of_pairs);
      if(place < pairs.size())
        pairs[place] = {begin + i, front.next(v, i)};
    }
  }
};

// The hooking and jumping, in turns, as a program for `run_steps()`: it hooks in odd steps, and
// jumps in even ones.
class Label_front : public Rounds
{
public:
  Label_front(const Span<const Front_pair>& pairs,
              const Span<Index>& label,
              const Span<std::uint32_t>& changed)
      : Rounds(changed)
      , pairs_(pairs)
      , label_(label) {}

  CGAL_HTL_HOST_DEVICE Index size(const State&) const { return static_cast<Index>(pairs_.size()); }
  CGAL_HTL_HOST_DEVICE void end_step(State& state) const {
    if(state.step % 2 != 0)
      Rounds::end_step(state);
  }

  CGAL_HTL_HOST_DEVICE void operator()(Index i, const State& state) const {
    if(state.step % 2 != 0)
      hook(pairs_[i], state);
    else
      jump(label_[pairs_[i].triangle]);
  }

private:
  CGAL_HTL_HOST_DEVICE void hook(const Front_pair& pair, const State& state) const {
    const Index a = racy_load(label_[pair.triangle]), b = racy_load(label_[pair.neighbor]);
    if(a == b)
      return;
    fetch_min(label_[a < b ? b : a], a < b ? a : b);
    note_change(state);
  }

  CGAL_HTL_HOST_DEVICE void jump(Index& label) const {
    Index root = racy_load(label);
    for(Index next = racy_load(label_[root]); next != root; next = racy_load(label_[root]))
      root = next;
    racy_store(label, root);
  }

  Span<const Front_pair> pairs_;
  Span<Index> label_;
};

} // namespace front_labels

#endif // HTL_TEST_FRONT_LABELS_H
