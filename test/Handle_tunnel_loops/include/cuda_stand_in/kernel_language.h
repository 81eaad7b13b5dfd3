#ifndef HTL_TEST_CUDA_STAND_IN_KERNEL_LANGUAGE_H
#define HTL_TEST_CUDA_STAND_IN_KERNEL_LANGUAGE_H

// What the compiler for devices adds to C++, as far as it is used: a kernel is a function that
// finds the number of its thread in variables.

// NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier): CUDA's names

#define __global__
#define __device__
#define __host__
#define __launch_bounds__(...)

struct uint3
{
  unsigned x, y, z;
};

struct dim3
{
  unsigned x, y, z;
  constexpr dim3(unsigned vx = 1, unsigned vy = 1, unsigned vz = 1)
      : x(vx)
      , y(vy)
      , z(vz) {}
  constexpr unsigned size() const { return x * y * z; }
};

struct alignas(16) float4
{
  float x, y, z, w;
};

inline thread_local uint3 threadIdx, blockIdx;
inline thread_local dim3 blockDim, gridDim;

// NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier)

#endif // HTL_TEST_CUDA_STAND_IN_KERNEL_LANGUAGE_H
