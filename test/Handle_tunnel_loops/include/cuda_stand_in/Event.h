#ifndef HTL_TEST_CUDA_STAND_IN_EVENT_H
#define HTL_TEST_CUDA_STAND_IN_EVENT_H

#include "Stream.h"

#include <chrono>
#include <memory>

namespace cuda_stand_in {

// A place in a stream, and when the work came there.
class Event
{
public:
  // The event is its own to the stream, and outlives what the program does to it.
  static void record(const std::shared_ptr<Event>& event, const std::shared_ptr<Stream>& stream) {
    event->stream_ = stream;
    event->has_come_ = false;
    stream->put([event] {
      event->time_ = std::chrono::steady_clock::now();
      event->has_come_ = true;
    });
  }

  bool is_recorded() const { return stream_.lock() != nullptr || has_come_; }
  bool has_come() const { return has_come_; }

  void wait() {
    if(const std::shared_ptr<Stream> stream = stream_.lock())
      stream->run();
  }

  static float milliseconds(const Event& begin, const Event& end) {
    return std::chrono::duration<float, std::milli>(end.time_ - begin.time_).count();
  }

private:
  std::weak_ptr<Stream> stream_;
  std::chrono::steady_clock::time_point time_;
  bool has_come_ = false;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_EVENT_H
