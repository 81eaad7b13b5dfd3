#ifndef HTL_TEST_QUIET_PROGRESS_H
#define HTL_TEST_QUIET_PROGRESS_H

#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

// Of passes that run without anybody looking on.
class Quiet_progress : public CGAL::Handle_tunnel_loops::internal::Progress
{
  using Stage = CGAL::Handle_tunnel_loops::Stage;

public:
  Quiet_progress()
      : Progress(
            {}, [](Stage) {}, [](Stage) {}, statistics_, stages_of_loops()) {}

private:
  CGAL::Handle_tunnel_loops::Statistics statistics_;
};

#endif // HTL_TEST_QUIET_PROGRESS_H
