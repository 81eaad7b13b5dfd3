// Cuda_tag against the solvers of the host: its library runs on the stand-in for the CUDA runtime.

#include "Cuda_runtime_test.h"
#include "Same_loops.h"
#include "Solver_agreement_tests.h"

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif

#include <gtest/gtest.h>

#include <iterator>

namespace test_cuda_agreement {

using namespace cuda_runtime_test;

// On a device of one thread, for speed.
class Cuda_agreement : public Cuda_runtime
{
protected:
  void SetUp() override {
    Device_kind kind;
    kind.multiprocessors = kind.threads_per_block = 1;
    use_devices({kind});
  }
};

using Solvers = testing::Types<Comparison<CGAL::Cuda_tag, CGAL::Sequential_tag, Cuda_agreement>
#ifdef CGAL_EIGEN3_ENABLED
                               ,
                               Comparison<CGAL::Reference_tag, CGAL::Cuda_tag, Cuda_agreement>
#endif
                               >;
INSTANTIATE_TYPED_TEST_SUITE_P(With_a_device, Solver, Solvers);

// They are not only as good.
TEST_F(Cuda_agreement, TheLoopsAreThoseOfTheHost) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    expect_same(pairs_of<CGAL::Cuda_tag>(mesh), find_loops(mesh));
  }
  EXPECT_GT(machine.devices[0]->number_of_kernels, unsigned(number_of_cases(1000)));
}

} // namespace test_cuda_agreement
