#ifndef HTL_TEST_HOST_EXECUTOR_H
#define HTL_TEST_HOST_EXECUTOR_H

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Lets a number of threads wait for each other.
class Barrier
{
public:
  explicit Barrier(unsigned number_of_threads)
      : number_of_threads_(number_of_threads) {}

  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    const unsigned round = round_;
    if(++waiting_ == number_of_threads_) {
      waiting_ = 0;
      ++round_;
      all_here_.notify_all();
    } else
      all_here_.wait(lock, [&] { return round_ != round; });
  }

private:
  unsigned number_of_threads_, waiting_ = 0, round_ = 0;
  std::mutex mutex_;
  std::condition_variable all_here_;
};

/// Memory with an owner; counts what is in use.
template <typename T> class Host_buffer
{
public:
  Host_buffer() = default;
  Host_buffer(std::size_t size, std::size_t& bytes_in_use)
      : data_(new T[size])
      , size_(size)
      , bytes_in_use_(&bytes_in_use) {
    bytes_in_use += size * sizeof(T);
  }
  Host_buffer(Host_buffer&& other) noexcept { swap(other); }
  Host_buffer& operator=(Host_buffer&& other) noexcept {
    Host_buffer(std::move(other)).swap(*this);
    return *this;
  }
  ~Host_buffer() {
    if(bytes_in_use_ != nullptr)
      *bytes_in_use_ -= size_ * sizeof(T);
  }

  Span<T> span() const { return {data_.get(), size_}; }

private:
  void swap(Host_buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(bytes_in_use_, other.bytes_in_use_);
  }

  std::unique_ptr<T[]> data_;
  std::size_t size_ = 0;
  std::size_t* bytes_in_use_ = nullptr;
};

/*!
Runs on the processor what is written for the device, with the same division into threads, steps and
barriers: one after the other, one after the other in random order, or in threads of their own. Not
made to be fast: it is there so that all but the few lines of the device's own executor are tested
where there is no device.
*/
class Host_executor : public Host_memory
{
public:
  template <typename T> using Buffer = Host_buffer<T>;

  enum class Order { FORWARD, SHUFFLED, THREADS };

  /// \p memory is what may be in use at one time, in bytes.
  explicit Host_executor(Order order = Order::FORWARD, std::size_t memory = std::size_t(1) << 40)
      : order_(order)
      , memory_(memory) {}

  Host_executor(const Host_executor&) = delete;
  Host_executor& operator=(const Host_executor&) = delete;

  /// nothing to choose for a call, nothing that is timed: as of `Device_solver`.
  int scope() const { return 0; }
  std::map<std::string, device::Kernel_cost> kernels() const { return {}; }

  std::size_t bytes_in_use() const { return bytes_in_use_; }
  std::size_t free_bytes() const { return memory_ - (std::min)(memory_, bytes_in_use_); }

  template <typename T> Buffer<T> make(std::size_t size) {
    if(size * sizeof(T) > free_bytes())
      throw Out_of_device_memory_exception(size * sizeof(T), free_bytes());
    return Buffer<T>(size, bytes_in_use_);
  }

  /// calls `f(i)` for i in [0, n).
  template <typename Function> void for_each(std::size_t n, const Function& f) {
    run(One_step<Function>{f, static_cast<Index>(n)});
  }

  /// the same, with a number that is on the device, and at most `limit`.
  template <typename Function>
  void for_each_of(const Index* n, std::size_t limit, const Function& f) {
    for_each((std::min<std::size_t>)(*n, limit), f);
  }

  /// runs a program of many steps, see `run_steps()`.
  template <typename Program> void run(const Program& program, std::size_t = 0) {
    if(order_ == Order::THREADS)
      return run_in_threads(program);
    Threads threads = {*this, nullptr, 0, 1};
    run_steps(program, threads);
  }

private:
  static constexpr unsigned number_of_threads = 4;

  template <typename Function> struct One_step
  {
    const Function& f;
    Index n;

    struct State
    {
      bool is_done;
    };
    State load() const { return {n == 0}; }
    void store(const State&) const {}
    bool begin_step(State& state) const { return !std::exchange(state.is_done, true); }
    void clear_ahead(const State&) const {}
    Index size(const State&) const { return n; }
    void end_step(State&) const {}
    void operator()(Index i, const State&) const { f(i); }
  };

  struct Threads
  {
    Host_executor& executor;
    Barrier* barrier;
    unsigned rank, number;

    bool is_first() const { return rank == 0; }
    void wait() {
      if(barrier != nullptr)
        barrier->wait();
    }
    template <typename Program, typename State>
    void for_each(Index n, const Program& program, const State& state) {
      if(executor.order_ == Order::SHUFFLED)
        return executor.for_each_shuffled(n, program, state);
      for(Index i = rank; i < n; i += number)
        program(i, state);
    }
  };

  template <typename Program, typename State>
  void for_each_shuffled(Index n, const Program& program, const State& state) {
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), random_);
    for(Index i : order)
      program(i, state);
  }

  template <typename Program> void run_in_threads(const Program& program) {
    Barrier barrier(number_of_threads);
    std::vector<std::thread> workers;
    for(unsigned rank = 0; rank < number_of_threads; ++rank)
      workers.emplace_back([&, rank] {
        Threads threads = {*this, &barrier, rank, number_of_threads};
        run_steps(program, threads);
      });
    for(std::thread& worker : workers)
      worker.join();
  }

  Order order_;
  std::size_t memory_;
  std::size_t bytes_in_use_ = 0;
  std::mt19937 random_{1};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // HTL_TEST_HOST_EXECUTOR_H
