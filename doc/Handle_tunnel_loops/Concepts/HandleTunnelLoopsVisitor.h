/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsVisitor` describes the requirements on a visitor that is called at the
beginning and at the end of each stage of the computation of handle and tunnel loops. Pass a model
of it as the named parameter `visitor`. The visitor is copied; pass `std::ref(visitor)` to keep its
state.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Handle_tunnel_loops::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::handle_tunnel_loops()`
\sa `CGAL::Handle_tunnel_loops_solver`
*/
class HandleTunnelLoopsVisitor
{
public:
  /// Called when a stage begins, by the thread that called the function.
  void start_stage(CGAL::Handle_tunnel_loops::Stage stage);

  /// Called when a stage ends, by the thread that called the function.
  void end_stage(CGAL::Handle_tunnel_loops::Stage stage);
};
