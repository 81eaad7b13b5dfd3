#ifndef HTL_TEST_CUDA_STAND_IN_COOPERATIVE_GROUPS_H
#define HTL_TEST_CUDA_STAND_IN_COOPERATIVE_GROUPS_H

#include "Grid.h"

namespace cooperative_groups {

class grid_group
{
public:
  // Only in a cooperative launch: on a device the result would be undefined.
  void sync() const {
    if(cuda_stand_in::barrier_of_grid == nullptr)
      cuda_stand_in::complaints.add("a barrier of the grid in a launch that is not cooperative");
    else
      cuda_stand_in::barrier_of_grid->wait();
  }
};

inline grid_group this_grid() { return {}; }

} // namespace cooperative_groups

#endif // HTL_TEST_CUDA_STAND_IN_COOPERATIVE_GROUPS_H
