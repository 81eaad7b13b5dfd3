#include "htloops/terminal/interrupt.h"

#include "Temporary_folder.h"

#include "htloops/write/text_writer.h"

#include <gtest/gtest.h>

#include <csignal>

using namespace htloops;

// One test only: that a signal came is not forgotten as long as the program runs.
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
