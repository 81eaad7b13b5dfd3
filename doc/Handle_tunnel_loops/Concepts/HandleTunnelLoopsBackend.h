/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsBackend` describes who computes the fields of the passes on one mesh,
and reads off them what is handed over: contours at saddles, closed walks, and arrival times where
these are asked for. Fields themselves stay where they are, in the memory of the processor or of a
device. It is the template parameter of the passes on arrival times (see \ref HTLDesign); names of
it may change.

All models give the same answers to the last bit: the formulas are those of
`internal/field/phase_field.h`, in single precision, and arrival times are integers.

Each call throws `CGAL::Handle_tunnel_loops::Interrupted_exception` when its callback returns
`false`. A model on a device throws `CGAL::Handle_tunnel_loops::Device_exception` when the device
fails, but for the one that goes on on the processor then.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::Host_backend}
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::device::Device_solver}
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::Fallback_backend}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsPasses`
*/
class HandleTunnelLoopsBackend
{
public:
  /// \name Types
  /// @{

  /// the number of a vertex: an unsigned integer of 32 bits.
  typedef CGAL::Handle_tunnel_loops::internal::Index Index;

  /// an arrival time, in ticks.
  typedef CGAL::Handle_tunnel_loops::internal::Time Time;

  /// the coefficients of one step of the field.
  typedef CGAL::Handle_tunnel_loops::internal::Step_coefficients Step_coefficients;

  /// a contour below a saddle at which two contours meet, with the saddle and an earlier neighbor
  /// within either contour.
  typedef CGAL::Handle_tunnel_loops::internal::Handle_candidate Handle_candidate;

  /// a sequence of crossed edges.
  typedef CGAL::Handle_tunnel_loops::internal::Crossing_loop Crossing_loop;

  /// which loops cross the edges at a vertex.
  typedef CGAL::Handle_tunnel_loops::internal::Crossing_index Crossing_index;

  /// loops, the numbers of those for which dual loops are looked for, whether all of the later
  /// loops or the own loop only are walls, how many walks are enough, and bounds on steps and
  /// updates.
  typedef CGAL::Handle_tunnel_loops::internal::Dual_loop_query Dual_loop_query;

  /// closed walks that cross one loop once, those found first coming first; and whether the search
  /// was given up for a bound.
  typedef CGAL::Handle_tunnel_loops::internal::Dual_walks Dual_walks;

  /// events of the fronts, and the layer of each vertex.
  typedef CGAL::Handle_tunnel_loops::internal::Front_log Front_log;

  /// `std::function<bool(double)>`: is told a part in [0, 1], and returns whether to go on.
  typedef CGAL::Handle_tunnel_loops::internal::Callback Callback;

  /// @}

  /// \name Operations
  /// @{

  /// computes the field of the initial pass, from one vertex in each component, and returns what
  /// its saddles offer as handles, in their order: as many as the genus. The callback is called by
  /// the calling thread.
  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback);

  /// returns the arrival times of the last initial field, by vertex.
  std::vector<Time> arrival_times();

  /// returns what happened to the fronts of the last initial field.
  Front_log front_log();

  /// computes one field from both sides of all loops, none of which it crosses, and returns its
  /// arrival times.
  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k);

  /// computes one field from vertices, some perhaps given twice, and their neighbors, and returns
  /// its arrival times: 0 and 1 there, and `never` in components without one. The callback is
  /// called by the calling thread.
  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback);

  /// computes the fields of the loop passes, and returns what is found for each of the numbers of
  /// the query. The callback may be called by several threads at a time.
  std::vector<Dual_walks>
  dual_walks(const Dual_loop_query& query, const Step_coefficients& k, const Callback& callback);

  /// fills `backend`, `fallback` and `device_bytes` of the statistics.
  void report(CGAL::Handle_tunnel_loops::Statistics& statistics) const;

  /// @}
};
