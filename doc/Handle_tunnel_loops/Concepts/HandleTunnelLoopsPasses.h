/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsPasses` describes the requirements on the passes of a method (section
4 of the paper). The concept documents the design of the package (see \ref HTLDesign). It is not
part of the stable interface: its names may change.

The pipeline calls the passes in the order in which they are listed here, each at most once. It
calls `refinement_pass()` only if `Solver_options::do_refine_handles` is set, and `shorten()` only
if `Solver_options::do_tighten` is set. It calls none of them for a surface of genus 0, unless the
caller requests the fronts of the initial pass. The loops found need not bound on any side: the
stage `CLASSES`, which follows, is the same for all models.

The concurrency tag selects the model. It is constructed from the arrays of a model of
`HandleTunnelLoopsMeshAdaptor`, which must outlive it, from one seed vertex per component, and from
the options.

Every pass reports its progress, and throws `CGAL::Handle_tunnel_loops::Interrupted_exception` if
the caller stops the computation. The result may depend on the mesh, the seeds and the options, but
not on the number of threads.

\cgalHasModelsBegin
\cgalHasModels{the passes of all concurrency tags except `CGAL::Reference_tag`; their template
parameter is a model of `HandleTunnelLoopsBackend`;}
\cgalHasModels{the passes of `CGAL::Reference_tag`}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsBackend`
\sa `HandleTunnelLoopsMeshAdaptor`
*/
class HandleTunnelLoopsPasses
{
public:
  /// \name Types
  /// @{

  /// The number of a vertex: an unsigned integer type of 32 bits.
  typedef unspecified_type Index;

  /// An arrival time: an unsigned integer type, in ticks. One value, `never`, represents infinity.
  typedef unspecified_type Time;

  /// Receives the progress of a pass, and throws
  /// `CGAL::Handle_tunnel_loops::Interrupted_exception` if the caller stops the computation.
  typedef unspecified_type Progress;

  /// A pair of closed curves, each a cyclic sequence of crossed edges. It is not decided yet which
  /// of the two is the handle loop.
  typedef unspecified_type Flat_pair;

  /// For each vertex, the layer of the front that reached it and the arrival time; empty unless the
  /// options request them.
  typedef unspecified_type Swept_vertices;

  /// @}

  /// \name Operations
  /// @{

  /// Finds handle loops, as many as the genus (paper, section 4.1). Records the events of the
  /// fronts in the statistics, at least if the options request it.
  void initial_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// Returns the layers and arrival times of the vertices in the initial pass, as far as the
  /// options request them.
  Swept_vertices take_swept_vertices();

  /// Finds a tunnel loop for each handle loop such that all loops are a basis (paper, section 4.2).
  /// Records in `kept_sweep_tunnels` for how many handles the field found none.
  void tunnel_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// Replaces handle loops by shorter ones, provided that the loops remain a basis (paper, section
  /// 4.3). Records in `kept_sweep_handles` how many were kept.
  void refinement_pass(Progress& progress, CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// Shortens all loops as far as it can. It may do nothing.
  void shorten(Progress& progress);

  /// Moves the pairs out of the object and returns them.
  std::vector<Flat_pair> take_pairs();

  /// Returns the arrival times of a field that grows from `vertices` (paper, section 6). The time
  /// is `never` in components without such a vertex. Records the backend in the statistics. It may
  /// be called before the passes, after them, or without them, and more than once.
  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              CGAL::Handle_tunnel_loops::Statistics& statistics);

  /// @}
};
