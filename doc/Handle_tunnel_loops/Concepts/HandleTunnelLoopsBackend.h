/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsBackend` describes the requirements on a backend, which computes the
fields of the passes on one mesh. A backend keeps its fields in the memory of the processor or of a
device, and returns only what is read off them: contours at saddles, closed walks, and arrival times
on request. It is the template parameter of the passes on arrival times. The concept documents the
design of the package (see \ref HTLDesign). It is not part of the stable interface: its names may
change.

All models return identical results, bit by bit. They evaluate the same formulas in single
precision, and arrival times are integers.

Each operation throws `CGAL::Handle_tunnel_loops::Interrupted_exception` if its callback returns
`false`. A model on a device throws `CGAL::Handle_tunnel_loops::Device_exception` if the device
fails, except for the model that continues on the processor in this case.

\cgalHasModelsBegin
\cgalHasModels{the backend of `CGAL::Sequential_tag` and `CGAL::Parallel_tag` on the processor;}
\cgalHasModels{the backend of `CGAL::Cuda_tag` on a CUDA device;}
\cgalHasModels{the backend of `CGAL::Cuda_if_available_tag` on a device or on the processor}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsPasses`
*/
class HandleTunnelLoopsBackend
{
public:
  /// \name Types
  /// @{

  /// The number of a vertex: an unsigned integer type of 32 bits.
  typedef unspecified_type Index;

  /// An arrival time: an unsigned integer type, in ticks. One value, `never`, represents infinity.
  typedef unspecified_type Time;

  /// The coefficients of one explicit Euler step of the field: those of diffusion, driving force
  /// and penalty, and the number of idle steps after which a stalled field is restarted.
  typedef unspecified_type Step_coefficients;

  /// A closed curve as the cyclic sequence of the edges that it crosses. Consecutive edges belong
  /// to one triangle.
  typedef unspecified_type Crossing_loop;

  /// A candidate for a handle: a saddle at which two contours merge, one of these contours as a
  /// `Crossing_loop`, and an earlier neighbor of the saddle within either contour.
  typedef unspecified_type Handle_candidate;

  /// An index that returns, for each vertex, the loops that cross its edges.
  typedef unspecified_type Crossing_index;

  /// A search for dual loops. It contains the loops, the numbers of those for which dual loops are
  /// requested, whether only the loop itself or all later loops as well are barriers, the number of
  /// walks per loop that suffices, and limits of the numbers of steps and updates.
  typedef unspecified_type Dual_loop_query;

  /// Closed walks on the edges that cross one loop once, in the order in which they were found, and
  /// whether the search reached a limit.
  typedef unspecified_type Dual_walks;

  /// The events of the fronts, and the layer of each vertex.
  typedef unspecified_type Front_log;

  /// `std::function<bool(double)>`: takes the progress in [0, 1] and returns whether to continue.
  typedef unspecified_type Callback;

  /// @}

  /// \name Operations
  /// @{

  /*!
  Computes the field of the initial pass, which starts at `seeds`, and returns the candidates at its
  saddles in their order. There are as many as the genus. The calling thread calls the callback.
  \pre `seeds` contains one vertex of each component.
  */
  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback);

  /// Returns the arrival times of the last initial field, by vertex.
  std::vector<Time> arrival_times();

  /// Returns the events and layers of the fronts of the last initial field.
  Front_log front_log();

  /// Computes one field that starts at both sides of all loops and crosses none of them. Returns
  /// its arrival times.
  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k);

  /// Computes one field that starts at `vertices`, which may contain duplicates, and their
  /// neighbors. Returns its arrival times: 0 at the vertices, 1 at their neighbors, and `never` in
  /// components without such a vertex. The calling thread calls the callback.
  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback);

  /// Computes the fields of the loop passes. Returns the walks for each number in the query.
  /// Several threads may call the callback at the same time.
  std::vector<Dual_walks>
  dual_walks(const Dual_loop_query& query, const Step_coefficients& k, const Callback& callback);

  /// Sets `backend`, `fallback` and `device_bytes` in the statistics.
  void report(CGAL::Handle_tunnel_loops::Statistics& statistics) const;

  /// @}
};
