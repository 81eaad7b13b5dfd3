#ifndef HTL_TEST_QUIET_PROGRESS_H
#define HTL_TEST_QUIET_PROGRESS_H

#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

// Of passes that run without anybody looking on.
class Quiet_progress
{
  using Progress = CGAL::Handle_tunnel_loops::internal::Progress;
  using Stage = CGAL::Handle_tunnel_loops::Stage;

public:
  operator Progress&() { return progress_; }

private:
  CGAL::Handle_tunnel_loops::Statistics statistics_;
  Progress progress_{{}, [](Stage) {}, [](Stage) {}, statistics_, Progress::stages_of_loops()};
};

#endif // HTL_TEST_QUIET_PROGRESS_H
