#ifndef HTL_TEST_CUDA_STAND_IN_OWNED_H
#define HTL_TEST_CUDA_STAND_IN_OWNED_H

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace cuda_stand_in {

// The objects of one kind that a program has made and has not destroyed yet, by their handles.
template <typename T> class Owned
{
public:
  T* add(const std::shared_ptr<T>& object) {
    add(object.get(), object);
    return object.get();
  }
  void add(const void* handle, const std::shared_ptr<T>& object) {
    const std::lock_guard<std::mutex> lock(mutex_);
    objects_[handle] = object;
  }

  // Null if there is none of that handle.
  std::shared_ptr<T> find(const void* handle) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = objects_.find(handle);
    return found == objects_.end() ? nullptr : found->second;
  }

  std::shared_ptr<T> take(const void* handle) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = objects_.find(handle);
    if(found == objects_.end())
      return nullptr;
    std::shared_ptr<T> object = std::move(found->second);
    objects_.erase(found);
    return object;
  }

  std::size_t size() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return objects_.size();
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    objects_.clear();
  }

private:
  mutable std::mutex mutex_;
  std::map<const void*, std::shared_ptr<T>> objects_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_OWNED_H
