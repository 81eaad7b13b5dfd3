#include "app/write/files.h"

#include "Temporary_folder.h"

#include "app/failure.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace test_htloops_atomic_file {

namespace fs = std::filesystem;
using namespace htloops;

void write(const std::string& file, const std::string& text) {
  Text_writer out(file);
  out << text;
  out.finish();
}

Exit_code code_of_failure(const std::string& file) {
  try {
    check_writable(file);
  } catch(const Failure& failure) {
    return failure.code();
  }
  return Exit_code::DONE;
}

TEST(Atomic_file, appears_when_it_is_committed) {
  const Temporary_folder folder;
  Text_writer out(folder.path("a.txt"));
  out << "text " << 0.1 << ' ' << 7u;
  EXPECT_FALSE(fs::exists(folder.path("a.txt")));
  out.finish();
  EXPECT_EQ(folder.read("a.txt"), "text 0.1 7");
  EXPECT_EQ(folder.number_of_files(), 1u);
}

TEST(Atomic_file, leaves_nothing_when_it_is_not_committed) {
  const Temporary_folder folder;
  folder.write("old.txt", "old");
  {
    Text_writer out(folder.path("old.txt"));
    out << std::string(1 << 20, 'x');
    EXPECT_EQ(folder.number_of_files(), 2u);
  }
  EXPECT_EQ(folder.number_of_files(), 1u);
  EXPECT_EQ(folder.read("old.txt"), "old");
}

TEST(Atomic_file, replaces_a_file_and_keeps_its_permissions) {
  const Temporary_folder folder;
  folder.write("a.txt", "old");
  fs::permissions(folder.path("a.txt"), fs::perms::owner_read | fs::perms::owner_write);
  write(folder.path("a.txt"), "new");
  EXPECT_EQ(folder.read("a.txt"), "new");
  EXPECT_EQ(fs::status(folder.path("a.txt")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Atomic_file, writes_through_a_symbolic_link) {
  const Temporary_folder folder;
  folder.write("real.txt", "old");
  fs::create_symlink("real.txt", folder.path("link.txt"));
  write(folder.path("link.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.path("link.txt")));
  EXPECT_EQ(folder.read("real.txt"), "new");
}

TEST(Atomic_file, writes_through_links_that_lead_to_nothing_yet) {
  const Temporary_folder folder;
  fs::create_directory(folder.path("folder"));
  fs::create_symlink("folder/second.txt", folder.path("first.txt"));
  fs::create_symlink("../real.txt", folder.path("folder/second.txt"));
  EXPECT_EQ(code_of_failure(folder.path("first.txt")), Exit_code::DONE);
  write(folder.path("first.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.path("first.txt")));
  EXPECT_TRUE(fs::is_symlink(folder.path("folder/second.txt")));
  EXPECT_EQ(folder.read("real.txt"), "new");
}

TEST(Atomic_file, leaves_links_alone_that_lead_in_a_circle) {
  const Temporary_folder folder;
  fs::create_symlink("b.txt", folder.path("a.txt"));
  fs::create_symlink("a.txt", folder.path("b.txt"));
  EXPECT_EQ(code_of_failure(folder.path("a.txt")), Exit_code::WRONG_USAGE);
  EXPECT_TRUE(fs::is_symlink(folder.path("a.txt")));
  EXPECT_EQ(folder.number_of_files(), 2u);
}

TEST(Atomic_file, has_a_name_as_long_as_a_name_can_be) {
  const Temporary_folder folder;
  const std::string name = std::string(251, 'a') + ".txt";
  write(folder.path(name), "text");
  EXPECT_EQ(folder.read(name), "text");
}

TEST(Destination, is_the_same_for_all_names_of_a_file) {
  const Temporary_folder folder;
  const std::string file = destination_of(folder.path("a.txt"));
  EXPECT_EQ(destination_of(folder.path("./x/../a.txt")), file);
  fs::create_symlink("a.txt", folder.path("link.txt"));
  EXPECT_EQ(destination_of(folder.path("link.txt")), file);
  folder.write("a.txt", "");
  EXPECT_EQ(destination_of(folder.path("link.txt")), file);
  EXPECT_EQ(destination_of("a.txt"), destination_of("./a.txt"));
}

TEST(Atomic_file, says_beforehand_that_a_path_cannot_be_written) {
  const Temporary_folder folder;
  EXPECT_EQ(code_of_failure(folder.path("a.txt")), Exit_code::DONE);
  EXPECT_EQ(code_of_failure(folder.path("")), Exit_code::WRONG_USAGE);
  EXPECT_EQ(code_of_failure(folder.path("no/such/folder.txt")), Exit_code::WRONG_USAGE);
  EXPECT_EQ(folder.number_of_files(), 0u);
}

TEST(Atomic_file, reports_a_full_disk) {
  if(!fs::exists("/dev/full"))
    GTEST_SKIP() << "no /dev/full here";
  try {
    write("/dev/full", "text");
    FAIL() << "nothing was thrown";
  } catch(const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit_code::WRONG_USAGE);
  }
  EXPECT_TRUE(fs::exists("/dev/full")) << "a device must not be replaced";
}

} // namespace test_htloops_atomic_file
