#include "app/interrupt.h"

#include "Small_answer.h"
#include "Temporary_folder.h"

#include "app/draw/pages.h"
#include "app/draw/pictures.h"
#include "app/draw/scenes.h"
#include "app/failure.h"
#include "app/read/input_file.h"
#include "app/write/files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#ifndef _WIN32
#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#endif

namespace test_htloops_interrupt {

using namespace htloops;

// A shell ignores Ctrl-C for what it runs in the background, and so would these programs.
[[maybe_unused]] const auto ignored_before = std::signal(SIGINT, SIG_DFL);
#ifdef SIGPIPE
[[maybe_unused]] const auto ignored_pipe_before = std::signal(SIGPIPE, SIG_DFL);
#endif

// How a program ends that does something, which may be interrupted or fail.
template <typename Do_something> [[noreturn]] void end_after(Do_something do_something) {
  try {
    do_something();
  } catch(const Interrupted&) {
    std::_Exit(128 + interrupting_signal());
  } catch(const Failure& failure) {
    std::_Exit(static_cast<int>(failure.code()));
  }
  std::_Exit(0);
}

// Without a program of its own one test only: that a signal came is not forgotten as long as the
// program runs.
TEST(Interrupt, stops_the_writing_of_a_file_and_leaves_none) {
  const Temporary_folder folder;
  const Interrupt_guard guard;
  EXPECT_EQ(interrupting_signal(), 0);
  EXPECT_NO_THROW(throw_if_interrupted());
  {
    Text_writer out(folder.path("a.txt"));
    out << "text";
    std::raise(SIGINT);
    EXPECT_EQ(interrupting_signal(), SIGINT);
    std::raise(SIGINT); // while a file is unfinished, the second one does not kill either
    EXPECT_THROW(out.finish(), Interrupted);
  }
  EXPECT_EQ(folder.number_of_files(), 0u);
}

// By their name these tests come first: what they start must not have noted a signal yet.
// A file looks after itself, also where nobody else does.
TEST(Interrupt_DeathTest, no_signal_leaves_an_unfinished_file) {
  const Temporary_folder folder;
#ifdef SIGHUP
  const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
#else
  const int signals[] = {SIGINT, SIGTERM};
#endif
  for(const int signal : signals) {
    EXPECT_EXIT(end_after([&] {
                  Text_writer out(folder.path("a.txt"));
                  std::raise(signal);
                  out.finish();
                }),
                testing::ExitedWithCode(128 + signal), "");
    EXPECT_EQ(folder.number_of_files(), 0u) << signal;
  }
}

#ifndef _WIN32
// Nobody ever writes to it, or reads from it.
TEST(Interrupt_DeathTest, who_waits_for_a_pipe_hears_the_first_signal) {
  const Temporary_folder folder;
  const std::string pipe = folder.path("pipe.off");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto expect_end = [](const auto& wait) {
    EXPECT_EXIT(end_after([&] {
                  const Interrupt_guard guard;
                  const pthread_t waiting = pthread_self();
                  std::thread([waiting] {
                    std::this_thread::sleep_for(std::chrono::milliseconds(300));
                    pthread_kill(waiting, SIGTERM);
                  }).detach();
                  wait();
                }),
                testing::ExitedWithCode(128 + SIGTERM), "");
  };
  expect_end([&] { Input_file{pipe}; });
  expect_end([&] { Text_writer{pipe}; });
}

TEST(Interrupt_DeathTest, a_file_that_may_not_grow_is_an_error_of_writing) {
  const Temporary_folder folder;
  EXPECT_EXIT(end_after([&] {
                const rlimit limit = {1000, 1000};
                setrlimit(RLIMIT_FSIZE, &limit);
                Text_writer out(folder.path("a.txt"));
                out << std::string(1 << 20, 'x');
                out.finish();
              }),
              testing::ExitedWithCode(static_cast<int>(Exit_code::WRONG_USAGE)), "");
  EXPECT_EQ(folder.number_of_files(), 0u);
}

TEST(Interrupt_DeathTest, a_picture_or_page_that_does_not_fit_leaves_the_one_before) {
  const auto expect_kept = [](const char* name, const auto& write) {
    const Temporary_folder folder;
    const std::string file = folder.path(name);
    std::ofstream(file) << "as it was";
    EXPECT_EXIT(end_after([&] {
                  const htl_scene::Scene scene = scene_of_cut({}, "a.off", small_mesh(), {}, "");
                  const rlimit limit = {200, 200};
                  setrlimit(RLIMIT_FSIZE, &limit);
                  write(file, scene);
                }),
                testing::ExitedWithCode(static_cast<int>(Exit_code::WRONG_USAGE)), "");
    EXPECT_EQ(folder.number_of_files(), 1u);
    std::string kept;
    std::getline(std::ifstream(file), kept);
    EXPECT_EQ(kept, "as it was");
  };
  if(has_pictures)
    expect_kept("a.png", [](const std::string& file, const htl_scene::Scene& scene) {
      export_picture({file, {}, {}}, scene);
    });
  expect_kept("a.html", [](const std::string& file, const htl_scene::Scene& scene) {
    write_page(file, scene);
  });
}
#endif

TEST(Interrupt_DeathTest, stops_what_draws_a_picture) {
  if(!has_pictures)
    GTEST_SKIP() << "no pictures here";
  const Temporary_folder folder;
  EXPECT_EXIT(end_after([&] {
                const Interrupt_guard guard;
                std::raise(SIGTERM);
                export_picture({folder.path("a.png"), {}, {}},
                               scene_of_cut({}, "a.off", small_mesh(), {}, ""));
              }),
              testing::ExitedWithCode(128 + SIGTERM), "");
  EXPECT_EQ(folder.number_of_files(), 0u);
}

} // namespace test_htloops_interrupt
