#ifndef HTL_TEST_CUDA_STAND_IN_MACHINE_H
#define HTL_TEST_CUDA_STAND_IN_MACHINE_H

#include "Array.h"
#include "Calls.h"
#include "Event.h"
#include "Owned.h"

#include <memory>
#include <string>
#include <vector>

namespace cuda_stand_in {

// The devices, and what programs hold of them.
class Machine
{
public:
  // Begins anew, with other devices.
  void set_up(const std::vector<Device_kind>& kinds) {
    streams.clear(); // first, for what is still to be done needs all else
    events.clear();
    arrays.clear();
    pools.clear();
    devices.clear();
    for(const Device_kind& kind : kinds)
      devices.push_back(std::make_unique<Device>(kind));
    current_device = 0;
    Calls::last_error = cudaSuccess;
    calls.restart();
    complaints.take();
  }

  bool has(int device) const {
    return device >= 0 && static_cast<std::size_t>(device) < devices.size();
  }
  Device& current() { return *devices[static_cast<std::size_t>(current_device)]; }

  // What has not been given back, in words.
  std::string held() const {
    std::string all;
    const auto say = [&all](std::size_t number, const char* what) {
      if(number != 0)
        all += std::to_string(number) + ' ' + what + ' ';
    };
    say(streams.size(), "streams");
    say(events.size(), "events");
    say(pools.size(), "pools");
    say(arrays.size(), "arrays");
    for(const auto& device : devices)
      say(device->reserved_bytes(), "bytes");
    return all;
  }

  std::vector<std::unique_ptr<Device>> devices;
  Owned<Stream> streams;
  Owned<Event> events;
  Owned<Pool> pools;
  Owned<Array> arrays; // by their data
  Calls calls;

  static inline thread_local int current_device = 0;
};

inline Machine machine;

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_MACHINE_H
