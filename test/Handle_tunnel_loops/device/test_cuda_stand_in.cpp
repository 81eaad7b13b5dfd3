// The stand-in for the CUDA runtime sees what it is there to see.

#include <cooperative_groups.h>
#include <cuda_runtime.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace test_cuda_stand_in {

using cuda_stand_in::Device_kind;
using cuda_stand_in::machine;

__global__ void set(int* data, int value) { data[threadIdx.x] = value; }
__global__ void meet(int) { cooperative_groups::this_grid().sync(); }

class Cuda_stand_in : public testing::Test
{
protected:
  void SetUp() override {
    machine.set_up({Device_kind(), Device_kind()});
    ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
    cudaMemPoolProps properties = {};
    properties.allocType = cudaMemAllocationTypePinned;
    properties.location.type = cudaMemLocationTypeDevice;
    ASSERT_EQ(cudaMemPoolCreate(&pool, &properties), cudaSuccess);
  }
  void TearDown() override {
    EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
    EXPECT_EQ(cudaMemPoolDestroy(pool), cudaSuccess);
    EXPECT_EQ(machine.held(), "");
  }

  int* make(std::size_t size = 1) {
    void* data = nullptr;
    EXPECT_EQ(cudaMallocFromPoolAsync(&data, size * sizeof(int), pool, stream), cudaSuccess);
    return static_cast<int*>(data);
  }
  void give_back(int* data) { EXPECT_EQ(cudaFreeAsync(data, stream), cudaSuccess); }
  void wait() { EXPECT_EQ(cudaStreamSynchronize(stream), cudaSuccess); }

  template <typename... Parameters, typename... Arguments>
  cudaError_t start(unsigned threads, void (*kernel)(Parameters...), Arguments... arguments) {
    cudaLaunchConfig_t configuration = {};
    configuration.blockDim = dim3(threads);
    configuration.stream = stream;
    return cudaLaunchKernelEx(&configuration, kernel, arguments...);
  }

  cudaError_t copy_to_host(int* to, const int* from) {
    return cudaMemcpyAsync(to, from, sizeof(int), cudaMemcpyDeviceToHost, stream);
  }

  static void expect_one_complaint(const std::string& what) {
    const std::vector<std::string> all = cuda_stand_in::complaints.take();
    ASSERT_EQ(all.size(), 1u) << "of: " << what;
    EXPECT_NE(all[0].find(what), std::string::npos) << all[0];
  }

  cudaStream_t stream = nullptr;
  cudaMemPool_t pool = nullptr;
};

TEST_F(Cuda_stand_in, DoesNothingBeforeSomebodyWaits) {
  int* const data = make();
  int value = 1;
  EXPECT_EQ(start(1, set, data, 2), cudaSuccess);
  EXPECT_EQ(copy_to_host(&value, data), cudaSuccess);
  EXPECT_EQ(value, 1);
  wait();
  EXPECT_EQ(value, 2);
  give_back(data);
}

TEST_F(Cuda_stand_in, DropsWhatIsToBeDoneWhereItFails) {
  int* const data = make();
  int value = 1;
  EXPECT_EQ(copy_to_host(&value, data), cudaSuccess);
  machine.calls.restart({1, 1, cudaErrorLaunchFailure});
  EXPECT_EQ(cudaStreamSynchronize(stream), cudaErrorLaunchFailure);
  EXPECT_EQ(cudaGetLastError(), cudaErrorLaunchFailure);
  wait();
  EXPECT_EQ(value, 1);
  give_back(data);
}

TEST_F(Cuda_stand_in, LetsNobodyTouchTheMemoryOfADevice) {
  int* const data = make();
  EXPECT_DEATH(*data = 1, "");
  give_back(data);
}

TEST_F(Cuda_stand_in, SeesWhatIsNotGivenBack) {
  int* const data = make(1000);
  EXPECT_EQ(machine.held(), "1 streams 1 pools 1 arrays 4096 bytes ");
  give_back(data);
  wait();
  EXPECT_EQ(machine.held(), "1 streams 1 pools 4096 bytes ");
  EXPECT_EQ(cudaMemPoolTrimTo(pool, 0), cudaSuccess);
  EXPECT_EQ(machine.held(), "1 streams 1 pools ");
}

TEST_F(Cuda_stand_in, SeesWhatIsGivenBackTwice) {
  int* const data = make();
  give_back(data);
  EXPECT_EQ(cudaFreeAsync(data, stream), cudaErrorInvalidValue);
  expect_one_complaint("is not in use");
  EXPECT_EQ(cudaStreamDestroy(nullptr), cudaErrorInvalidResourceHandle);
  expect_one_complaint("destroyed that is not there");
}

TEST_F(Cuda_stand_in, SeesKernelsThatAreGivenWrongMemory) {
  int on_host = 0;
  int* const data = make();
  EXPECT_EQ(start(1, set, &on_host, 1), cudaSuccess);
  give_back(data);
  wait();
#ifdef __GNUC__
#ifndef __clang__
  expect_one_complaint("is given memory that is not of its device");
#endif
#endif
}

TEST_F(Cuda_stand_in, SeesWhatIsWrittenPastTheEnd) {
  int* const data = make();
  EXPECT_EQ(start(2, set, data, 1), cudaSuccess);
  give_back(data);
  wait();
  expect_one_complaint("past the end");
}

TEST_F(Cuda_stand_in, CopiesBetweenAHostAndItsDeviceOnly) {
  int on_host[2] = {};
  int* const data = make();
  EXPECT_EQ(copy_to_host(on_host, on_host + 1), cudaErrorInvalidValue);
  EXPECT_EQ(copy_to_host(data, data), cudaErrorInvalidValue);
  EXPECT_EQ(copy_to_host(on_host, data + 1), cudaSuccess);
  wait();
  expect_one_complaint("not in the memory of the device");
  give_back(data);
}

TEST_F(Cuda_stand_in, LaunchesOnlyWhatADeviceLaunches) {
  EXPECT_EQ(start(3, meet, 0), cudaErrorInvalidConfiguration);
  EXPECT_EQ(start(0, meet, 0), cudaErrorInvalidConfiguration);
  EXPECT_EQ(cudaSetDevice(1), cudaSuccess);
  EXPECT_EQ(start(1, meet, 0), cudaErrorInvalidResourceHandle);
  EXPECT_EQ(cudaSetDevice(0), cudaSuccess);
  EXPECT_EQ(start(1, meet, 0), cudaSuccess);
  wait();
  expect_one_complaint("a launch that is not cooperative");
}

} // namespace test_cuda_stand_in
