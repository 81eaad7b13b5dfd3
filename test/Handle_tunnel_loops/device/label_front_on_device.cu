#include "label_front_on_device.h"

#include "label_front.h"

#include "Cuda_executor.cuh"
#include "Stream.cuh"
#include "devices.cuh"

namespace front_labels {

std::vector<Index>
label_front_on_device(const Flat_mesh& mesh, const std::vector<Time>& times, Time level) {
  using namespace htl_cuda;
  const int device = usable_device(-1);
  const Stream stream(nullptr);
  Cuda_executor executor(device, stream.get());
  return label_front(executor, mesh, times, level);
}

} // namespace front_labels
