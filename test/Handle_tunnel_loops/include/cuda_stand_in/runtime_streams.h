#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_STREAMS_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_STREAMS_H

#include "runtime_calls.h"

// There is no default stream: whatever is put into it is an error.

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

inline cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned flags) {
  using namespace cuda_stand_in;
  return call([&] {
    if(machine.devices.empty())
      return cudaErrorNoDevice;
    if(flags != cudaStreamNonBlocking && flags != cudaStreamDefault)
      return cudaErrorInvalidValue;
    *stream = machine.streams.add(std::make_shared<Stream>(machine.current()));
    return cudaSuccess;
  });
}

inline cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  return cuda_stand_in::destroy(cuda_stand_in::machine.streams, stream);
}

// Fails as a device fails whose work was not to its liking: it does not do it.
inline cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
  using namespace cuda_stand_in;
  const std::shared_ptr<Stream> object = machine.streams.find(stream);
  return machine.calls.make(
      [&] {
        if(object == nullptr)
          return cudaErrorInvalidResourceHandle;
        object->run();
        return cudaSuccess;
      },
      [&] {
        if(object != nullptr)
          object->drop();
      });
}

inline cudaError_t cudaEventCreate(cudaEvent_t* event) {
  using namespace cuda_stand_in;
  return call([&] {
    *event = machine.events.add(std::make_shared<Event>());
    return cudaSuccess;
  });
}

inline cudaError_t cudaEventDestroy(cudaEvent_t event) {
  return cuda_stand_in::destroy(cuda_stand_in::machine.events, event);
}

inline cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
  using namespace cuda_stand_in;
  return call_for(machine.events, event, [&](const std::shared_ptr<Event>& object) {
    const std::shared_ptr<Stream> into = machine.streams.find(stream);
    if(into == nullptr)
      return cudaErrorInvalidResourceHandle;
    Event::record(object, into);
    return cudaSuccess;
  });
}

inline cudaError_t cudaEventSynchronize(cudaEvent_t event) {
  using namespace cuda_stand_in;
  return call_for(machine.events, event, [](const std::shared_ptr<Event>& object) {
    object->wait();
    return cudaSuccess;
  });
}

inline cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t begin, cudaEvent_t end) {
  using namespace cuda_stand_in;
  return call([&] {
    const std::shared_ptr<Event> first = machine.events.find(begin);
    const std::shared_ptr<Event> second = machine.events.find(end);
    if(first == nullptr || second == nullptr || !first->is_recorded() || !second->is_recorded())
      return cudaErrorInvalidResourceHandle;
    if(!first->has_come() || !second->has_come())
      return cudaErrorNotReady;
    *milliseconds = Event::milliseconds(*first, *second);
    return cudaSuccess;
  });
}

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_STREAMS_H
