/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsMeshAdaptor` describes the requirements on the class that converts a
mesh to plain arrays. The passes use these arrays only. The concept documents the design of the
package (see \ref HTLDesign). It is not part of the stable interface: its names may change, and you
cannot pass a model of it to a function.

\cgalHasModelsBegin
\cgalHasModels{the mesh adaptor that all functions and `CGAL::Handle_tunnel_loops_solver` use}
\cgalHasModelsEnd

\sa `HandleTunnelLoopsPasses`
\sa `CGAL::Handle_tunnel_loops_solver`
*/
class HandleTunnelLoopsMeshAdaptor
{
public:
  /// \name Types
  /// @{

  /// A model of `FaceListGraph`.
  typedef unspecified_type TriangleMesh;

  /// A model of `ReadablePropertyMap` with the vertices as keys and a unique index below
  /// \f$ 2^{31} - 2 \f$ as value. The indices may have gaps.
  typedef unspecified_type VertexIndexMap;

  /// A model of `ReadablePropertyMap` with the vertices as keys and points as values.
  /// `CGAL::to_double()` must accept their coordinates.
  typedef unspecified_type VertexPointMap;

  /// The number of threads to use, sequential or parallel. It does not affect the arrays.
  typedef unspecified_type Execution;

  /*!
  A closed, oriented 2-manifold triangle mesh without isolated vertices, as arrays. Each boundary
  curve of the original mesh is closed by a cap: a fan of faces around an additional vertex. These
  additional vertices come after all others. The other vertices may be in any order; the passes are
  faster if neighbors have similar numbers. The type has these members:

  - `points`: the coordinates of each vertex, translated and scaled to the unit cube. The factor
    that restores the caller's unit of length is stored as well.
  - `row_begin` and `neighbor`: the ring of neighbors of each vertex, counterclockwise.
  - `original`: the caller's index of each vertex.
  - `component`: the number of the connected component of each vertex.
  - `seeds`: for each component, its vertex of smallest caller's index.
  - `genus`: the genus, summed over the components.
  */
  typedef unspecified_type Flat_mesh;

  /// @}

  /// \name Construction
  /// @{

  /// Constructs an adaptor. It stores a reference to the mesh, which must outlive it.
  HandleTunnelLoopsMeshAdaptor(Execution execution,
                               const TriangleMesh& tm,
                               VertexIndexMap index,
                               VertexPointMap point);

  /// @}

  /// \name Operations
  /// @{

  /*!
  Returns the arrays.
  \pre It has not been called before on this object.
  \throws CGAL::Handle_tunnel_loops::Invalid_mesh_exception if the mesh is not an oriented
    2-manifold triangle mesh, with or without boundary, with finite coordinates. The message names
    an element.
  */
  Flat_mesh build();

  /*!
  Returns, for each vertex of the arrays except the additional vertices of caps, the vertex of the
  caller's mesh.
  \pre `build()` has been called.
  */
  std::vector<boost::graph_traits<TriangleMesh>::vertex_descriptor> take_vertices();

  /// @}
};
