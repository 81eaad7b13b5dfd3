/*!
\ingroup PkgHandleTunnelLoopsConcepts
\cgalConcept

The concept `HandleTunnelLoopsVisitor` describes what is told of the stages of the computation of
handle and tunnel loops. A visitor is passed by value: pass `std::ref(visitor)` to keep its state.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Handle_tunnel_loops::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::handle_tunnel_loops()`
\sa `CGAL::Handle_tunnel_loops_solver`
*/
class HandleTunnelLoopsVisitor
{
public:
  /// is called when a stage begins, in the thread that called the function.
  void start_stage(CGAL::Handle_tunnel_loops::Stage stage);

  /// is called when a stage has ended, in the thread that called the function.
  void end_stage(CGAL::Handle_tunnel_loops::Stage stage);
};
