#ifndef HTL_TEST_CUDA_RUNTIME_TEST_H
#define HTL_TEST_CUDA_RUNTIME_TEST_H

#include "cuda_runtime.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cuda_runtime_test {

using CGAL::Handle_tunnel_loops::Device_exception;
using cuda_stand_in::Device_kind;
using cuda_stand_in::Fault;
using cuda_stand_in::machine;

// Whatever a test does, in the end all is given back, when the memory is that is kept, and nothing
// was done that a device would not have survived.
class Cuda_runtime : public testing::Test
{
protected:
  void SetUp() override { machine.set_up({Device_kind()}); }
  void TearDown() override { expect_clean(); }

  // These from now on.
  static void use_devices(const std::vector<Device_kind>& kinds) {
    expect_clean();
    machine.set_up(kinds);
  }

  static void expect_clean() {
    CGAL::Handle_tunnel_loops::release_device_memory();
    EXPECT_EQ(machine.held(), "");
    EXPECT_EQ(cuda_stand_in::complaints.take(), std::vector<std::string>());
    EXPECT_EQ(machine.current_device, 0);
    EXPECT_EQ(cudaGetLastError(), cudaSuccess);
  }

  // Lets the first call of the runtime fail, and as many more as the fault says, then from the
  // second call on, and so forth as long as `f` makes so many; to be quicker, by so many percent
  // more. It throws a typed exception, or all is well in spite of the failure.
  template <typename Function>
  static void expect_survived(Fault fault, unsigned percent, const Function& f) {
    while(!HasFailure() && make_calls(fault, f) >= fault.first)
      fault.first += 1 + fault.first * percent / 100;
    EXPECT_GT(fault.first, 100u);
  }

private:
  // Returns how many there were.
  template <typename Function> static unsigned make_calls(const Fault& fault, const Function& f) {
    SCOPED_TRACE(testing::Message() << "call " << fault.first << " fails: " << fault.error);
    machine.calls.restart(fault);
    try {
      f();
    } catch(const Device_exception&) {
    }
    const unsigned number = machine.calls.number();
    machine.calls.restart();
    expect_clean();
    return number;
  }
};

} // namespace cuda_runtime_test

#endif // HTL_TEST_CUDA_RUNTIME_TEST_H
