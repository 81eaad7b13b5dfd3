/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsMeshAdaptor` describes what turns a mesh into plain arrays, which are
all that the passes know of it. It is a concept of the inside of the package (see \ref HTLDesign):
names of it are in `CGAL::Handle_tunnel_loops::internal`, and may change.

A `Flat_mesh` is a closed, oriented 2-manifold triangle mesh without isolated vertices:

- `points`: the coordinates of each vertex, moved and scaled into the unit box, and `scale`, the
  length of its unit in that of the caller;
- `row_begin` and `neighbor`: for each vertex the ring of its neighbors, counterclockwise;
- `original`: for each vertex its index in the caller's numbering;
- `component` and `seeds`: for each vertex the number of its component, and for each component the
  vertex of smallest caller's index;
- `genus`, summed over the components.

The vertices may be numbered in any order; passes are faster if neighbors are near in memory.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Handle_tunnel_loops::internal::Flat_mesh_builder}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsPasses`
\sa `CGAL::Handle_tunnel_loops_solver`
*/
class HandleTunnelLoopsMeshAdaptor
{
public:
  /// \name Types
  /// @{

  /// a model of `FaceListGraph`.
  typedef unspecified_type TriangleMesh;

  /// a model of `ReadablePropertyMap` with the vertices as keys: a unique index below
  /// \f$ 2^{32} - 2 \f$, with gaps or without.
  typedef unspecified_type VertexIndexMap;

  /// a model of `ReadablePropertyMap` with the vertices as keys and points as values, whose
  /// coordinates `CGAL::to_double()` takes.
  typedef unspecified_type VertexPointMap;

  /// @}

  /// \name Construction
  /// @{

  /// keeps a reference to the mesh. `execution` says by how many threads work is done; the arrays
  /// do not depend on it.
  HandleTunnelLoopsMeshAdaptor(CGAL::Handle_tunnel_loops::internal::Execution execution,
                               const TriangleMesh& tm,
                               VertexIndexMap index,
                               VertexPointMap point);

  /// @}

  /// \name Operations
  /// @{

  /// returns the arrays; to be called once.
  /// \throws CGAL::Handle_tunnel_loops::Invalid_mesh_exception if the mesh is not a closed,
  /// oriented
  ///   2-manifold triangle mesh with finite coordinates; it names an element
  CGAL::Handle_tunnel_loops::internal::Flat_mesh build();

  /// returns the vertex of the caller's mesh for each vertex of the arrays; after `build()`.
  std::vector<boost::graph_traits<TriangleMesh>::vertex_descriptor> take_vertices();

  /// @}
};
