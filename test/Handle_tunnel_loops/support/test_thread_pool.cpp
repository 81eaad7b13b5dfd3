// The threads of the package itself, whatever all else has been built with: each piece of work is
// done once, by as many as may, and the answer does not depend on how many there are.

#include <CGAL/Handle_tunnel_loops/internal/support/Thread_limit.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <mutex>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace test_thread_pool {

namespace internal = CGAL::Handle_tunnel_loops::internal;
using internal::for_each_index;
using internal::Thread_limit;
using internal::Thread_pool;
using internal::with_threads;

constexpr internal::Execution parallel = internal::Execution::parallel();

template <typename Function> void do_each(std::size_t n, const Function& f) {
  for_each_index(parallel, n, f, 1);
}

void rest() { std::this_thread::sleep_for(std::chrono::microseconds(200)); }

// Who is at work, and how many were at most.
class Workers
{
public:
  void work() {
    const std::size_t present = ++present_;
    std::size_t most = most_;
    while(present > most && !most_.compare_exchange_weak(most, present))
      continue;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      seen_.insert(std::this_thread::get_id());
    }
    rest();
    --present_;
  }

  // Returns when so many have come; says whether that took no more than half a minute.
  bool meet(std::size_t number) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(30);
    ++present_;
    while(present_ < number && Clock::now() < end)
      std::this_thread::yield();
    return present_ >= number;
  }

  std::size_t most() const { return most_; }
  std::set<std::thread::id> seen() const { return seen_; }

private:
  std::atomic<std::size_t> present_{0}, most_{0};
  std::mutex mutex_;
  std::set<std::thread::id> seen_;
};

std::vector<double> roots(internal::Execution execution, std::size_t n) {
  std::vector<double> result(n, 0.);
  for_each_index(
      execution, n, [&](std::size_t i) { result[i] += std::sqrt(double(i)); }, 7);
  return result;
}

TEST(Thread_pool, DoesAllOfTheWorkOnce) {
  for(const int threads : {1, 2, 3, 8}) {
    const Thread_limit limit(threads);
    for(const std::size_t n : {0, 1, 2, 6, 7, 8, 100, 12345})
      EXPECT_EQ(roots(parallel, n), roots(internal::Execution(), n)) << n << ' ' << threads;
  }
}

TEST(Thread_pool, HasAsManyThreadsAsItMayAtTheSameTime) {
  const Thread_limit limit(5);
  EXPECT_EQ(limit.number_of_threads(), 5);
  EXPECT_EQ(parallel.number_of_threads(), 5u);
  Workers workers;
  std::atomic<int> number_met{0};
  do_each(5, [&](std::size_t) { number_met += workers.meet(5); });
  EXPECT_EQ(number_met, 5);
}

TEST(Thread_pool, HasNoMoreThreadsThanItMay) {
  const Thread_limit wide(4);
  const Thread_limit limit(2);
  {
    const Thread_limit one(1);
    Workers alone;
    do_each(20, [&](std::size_t) { alone.work(); });
    EXPECT_EQ(alone.seen(), std::set<std::thread::id>{std::this_thread::get_id()});
  }
  Workers workers;
  for(int i = 0; i < 20; ++i)
    do_each(20, [&](std::size_t) { do_each(3, [&](std::size_t) { workers.work(); }); });
  EXPECT_LE(workers.most(), 2u);
}

TEST(Thread_pool, HasLimitsThatEnd) {
  const std::size_t all = parallel.number_of_threads();
  {
    const Thread_limit limit(3);
  }
  EXPECT_EQ(parallel.number_of_threads(), all);
  EXPECT_EQ(all, std::size_t(Thread_limit(0).number_of_threads()));
}

TEST(Thread_pool, LimitsACallWithAllThatItCalls) {
  const Thread_limit wide(4);
  Thread_pool::Team pair{{2}};
  Workers workers;
  std::thread other([&] {
    Thread_pool::join(&pair);
    for(int i = 0; i < 20; ++i)
      do_each(20, [&](std::size_t) {
        EXPECT_EQ(parallel.number_of_threads(), 2u);
        do_each(3, [&](std::size_t) { workers.work(); });
      });
  });
  for(int i = 0; i < 20; ++i)
    do_each(20, [](std::size_t) {
      EXPECT_EQ(parallel.number_of_threads(), 4u);
      rest();
    });
  other.join();
  EXPECT_LE(workers.most(), 2u);
}

TEST(Thread_pool, ForgetsATeamThatIsLeft) {
  const std::size_t all = parallel.number_of_threads();
  EXPECT_EQ(internal::in_team(1, [] { return parallel.number_of_threads(); }), 1u);
  EXPECT_THROW(internal::in_team(1, []() -> int { throw std::runtime_error("left"); }),
               std::runtime_error);
  EXPECT_EQ(parallel.number_of_threads(), all);
  EXPECT_EQ(with_threads(0, [] { return parallel.number_of_threads(); }), all);
}

TEST(Thread_pool, ThrowsWhatAPieceOfWorkThrewAndLeavesTheRestOut) {
  for(const int threads : {1, 4}) {
    const Thread_limit limit(threads);
    for(int round = 0; round < 50; ++round) {
      std::atomic<std::size_t> number_done{0};
      const auto work = [&](std::size_t i) {
        if(i == 10)
          throw std::out_of_range("ten");
        rest();
        ++number_done;
      };
      EXPECT_THROW(do_each(1000, work), std::out_of_range);
      EXPECT_LT(number_done, 900u);
    }
    EXPECT_EQ(roots(parallel, 1000), roots(internal::Execution(), 1000));
  }
}

TEST(Thread_pool, ThrowsThroughWorkWithinWork) {
  const Thread_limit limit(4);
  for(int round = 0; round < 50; ++round)
    EXPECT_THROW(do_each(8,
                         [](std::size_t i) {
                           do_each(8, [i](std::size_t j) {
                             if(i == 3 && j == 5)
                               throw std::out_of_range("within");
                           });
                         }),
                 std::out_of_range);
}

TEST(Thread_pool, DoesWorkWithinWork) {
  for(const int threads : {1, 2, 4}) {
    const Thread_limit limit(threads);
    for(int round = 0; round < 50; ++round) {
      std::atomic<std::size_t> sum{0};
      do_each(5, [&](std::size_t i) {
        do_each(6, [&](std::size_t j) { do_each(7, [&](std::size_t k) { sum += i * j * k; }); });
      });
      EXPECT_EQ(sum, 10u * 15u * 21u);
    }
  }
}

TEST(Thread_pool, HelpsWithWorkWithinWork) {
  const Thread_limit limit(4);
  Workers workers;
  std::atomic<int> number_met{0};
  do_each(2, [&](std::size_t i) {
    if(i == 0)
      do_each(4, [&](std::size_t) { number_met += workers.meet(4); });
  });
  EXPECT_EQ(number_met, 4);
}

TEST(Thread_pool, WorksForManyAtATime) {
  for(const int threads : {1, 2, 4}) {
    const Thread_limit limit(threads);
    const std::vector<double> expected = roots(internal::Execution(), 3000);
    std::atomic<int> number_right{0};
    std::vector<std::thread> callers;
    for(int c = 0; c < 8; ++c)
      callers.emplace_back([&] {
        for(int i = 0; i < 50; ++i)
          number_right += roots(parallel, 3000) == expected;
      });
    for(std::thread& caller : callers)
      caller.join();
    EXPECT_EQ(number_right, 400);
  }
}

#ifdef __linux__

std::size_t number_of_threads_of_this_process() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

TEST(Thread_pool, StartsNoThreadThatIsNotNeededAndKeepsThose) {
  const std::size_t before = number_of_threads_of_this_process();
  Thread_pool& pool = *new Thread_pool; // its threads never end
  const auto run = [&pool](std::size_t most, std::size_t number) {
    Thread_pool::Team team{{most}};
    Thread_pool::Team* const own = Thread_pool::join(&team);
    pool.run(number, nullptr, [](const void*, std::size_t) { rest(); });
    Thread_pool::join(own);
  };
  run(1, 100);
  run(8, 1);
  EXPECT_EQ(number_of_threads_of_this_process(), before);
  run(8, 3);
  EXPECT_EQ(number_of_threads_of_this_process(), before + 2);
  for(int i = 0; i < 10; ++i)
    run(4, 100);
  EXPECT_EQ(number_of_threads_of_this_process(), before + 3);
}

TEST(Thread_pool, LetsAProgramEndWhileItWorks) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      {
        const Thread_limit limit(4);
        std::atomic<bool> has_begun{false};
        std::thread([&] {
          for(;;)
            do_each(100, [&](std::size_t) {
              has_begun = true;
              rest();
            });
        }).detach();
        while(!has_begun)
          rest();
        roots(parallel, 10000);
        std::exit(7);
      },
      testing::ExitedWithCode(7), "");
}

#endif

TEST(Sort, IsThatOfOneThread) {
  std::mt19937 random(5);
  for(const std::size_t n : {0, 1, 2, 100, 8191, 8192, 8193, 50000, 300001})
    for(const unsigned values : {2u, 1000u, ~0u}) {
      std::vector<std::pair<unsigned, std::size_t>> items(n);
      for(std::size_t i = 0; i < n; ++i)
        items[i] = {values == ~0u ? unsigned(random()) : unsigned(random()) % values, i};
      const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
      auto expected = items;
      std::stable_sort(expected.begin(), expected.end(), less);
      for(const int threads : {1, 2, 5, 16, 17}) {
        const Thread_limit limit(threads);
        auto sorted = items;
        internal::sort(parallel, sorted.begin(), sorted.end(), less);
        EXPECT_EQ(sorted, expected) << n << ' ' << values << ' ' << threads;
      }
    }
}

TEST(Sort, TakesWhatIsInOrderAlready) {
  const Thread_limit limit(4);
  std::vector<int> up(100000), down(up.size());
  std::iota(up.begin(), up.end(), 0);
  std::reverse_copy(up.begin(), up.end(), down.begin());
  std::vector<int> again = up;
  for(std::vector<int>* items : {&again, &down}) {
    internal::sort(parallel, items->begin(), items->end(), std::less<int>());
    EXPECT_EQ(*items, up);
  }
}

} // namespace test_thread_pool
