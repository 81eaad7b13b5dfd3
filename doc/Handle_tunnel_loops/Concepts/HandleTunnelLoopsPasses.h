/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsPasses` describes the passes of a method (paper, section 4). The
pipeline calls them in the order in which they stand here, each at most once: `refinement_pass()`
only if `do_refine_handles` is set, `shorten()` only if `do_tighten` is. They are not called for a
surface of genus 0. What they find need not bound on any side: the stage `CLASSES`, which follows,
is the same for all models. In the package it is the abstract class
`CGAL::Handle_tunnel_loops::internal::Passes`, from which models derive (see \ref HTLDesign); names
of it may change.

A model is made by `Passes_of_tag<ConcurrencyTag>::%make()` from a `Flat_mesh`, the vertices to
start from (one in each component), and the options. The mesh outlives it.

Every pass reports its progress, and throws `CGAL::Handle_tunnel_loops::Interrupted_exception` when
somebody wants to stop. The answer may depend on the mesh, the seeds and the options, but not on the
number of threads.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::Field_passes}
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::reference::Reference_passes}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsBackend`
\sa `HandleTunnelLoopsMeshAdaptor`
*/
class HandleTunnelLoopsPasses
{
public:
  /// \name Types
  /// @{

  /// the number of a vertex: an unsigned integer of 32 bits.
  typedef CGAL::Handle_tunnel_loops::internal::Index Index;

  /// an arrival time, in ticks.
  typedef CGAL::Handle_tunnel_loops::internal::Time Time;

  /// is told how far the work has come, and knows whether to go on.
  typedef CGAL::Handle_tunnel_loops::internal::Progress Progress;

  /// two sequences of crossed edges. Which of them is the handle remains to be seen.
  typedef CGAL::Handle_tunnel_loops::internal::Flat_pair Flat_pair;

  /// @}

  /// \name Operations
  /// @{

  /// finds handle loops, as many as the genus (paper, 4.1), and notes in the
  /// statistics what it knows of the fronts, at least if that was asked for.
  void initial_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// finds a tunnel loop for each handle loop, such that all are a basis (paper, 4.2), and notes in
  /// `kept_sweep_tunnels` for how many the field found none.
  void tunnel_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// replaces handle loops by shorter ones, as far as the loops remain a basis (paper, 4.3), and
  /// notes in `kept_sweep_handles` how many stayed.
  void refinement_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// makes all loops as short as it can; may do nothing.
  void shorten(Progress& progress);

  /// returns the pairs, and keeps none.
  std::vector<Flat_pair> take_pairs();

  /// returns the arrival times of a field that grows from vertices (paper, section 6), `never` in
  /// components without one, and says in the statistics who computed it. May be called before the
  /// passes, after them, or without them, and more than once.
  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// @}
};
