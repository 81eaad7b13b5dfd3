#ifndef HTL_TEST_CUDA_STAND_IN_COMPLAINTS_H
#define HTL_TEST_CUDA_STAND_IN_COMPLAINTS_H

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace cuda_stand_in {

// What a device would have answered with a crash, or with nothing at all.
class Complaints
{
public:
  void add(const std::string& complaint) {
    const std::lock_guard<std::mutex> lock(mutex_);
    complaints_.push_back(complaint);
  }

  // All of them, which are forgotten then.
  std::vector<std::string> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(complaints_, {});
  }

private:
  std::mutex mutex_;
  std::vector<std::string> complaints_;
};

inline Complaints complaints;

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_COMPLAINTS_H
