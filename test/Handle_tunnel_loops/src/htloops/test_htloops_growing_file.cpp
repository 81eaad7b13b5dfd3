#include "app/write/growing_file.h"

#include "Temporary_folder.h"

#include "app/failure.h"
#include "app/write/line_files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace test_htloops_growing_file {

namespace fs = std::filesystem;
using namespace htloops;

// About a mesh that cannot be read: a row, and an object.
Mesh_line line_about(const std::string& mesh) { return {mesh, 3, "it is broken"}; }

std::string rows_about(const std::string& mesh) {
  Text rows;
  write_rows(rows, line_about(mesh), Row_kind::PAIRS);
  return rows.all();
}

const std::string header = header_of_rows(Row_kind::PAIRS);

TEST(Growing_file, keeps_what_was_there_until_something_comes) {
  const Temporary_folder folder;
  folder.write("a.csv", "old\n");
  Growing_file file(folder.path("a.csv"), "header\n");
  EXPECT_EQ(folder.read("a.csv"), "old\n");
  file.append("1\n2\n");
  EXPECT_EQ(folder.read("a.csv"), "header\n1\n2\n");
  file.append("3\n");
  EXPECT_EQ(folder.read("a.csv"), "header\n1\n2\n3\n");
  EXPECT_EQ(folder.number_of_files(), 1u);
}

TEST(Growing_file, writes_through_a_symbolic_link) {
  const Temporary_folder folder;
  fs::create_symlink("real.csv", folder.path("link.csv"));
  Growing_file(folder.path("link.csv")).append("1\n");
  EXPECT_TRUE(fs::is_symlink(folder.path("link.csv")));
  EXPECT_EQ(folder.read("real.csv"), "1\n");
}

#ifndef _WIN32
// Ends with the exit code of what fails when a file may not grow any more.
[[noreturn]] void write_too_much(const std::string& name) {
  std::signal(SIGXFSZ, SIG_IGN);
  Growing_file file(name);
  file.append("short\n");
  const rlimit limit = {1000, 1000};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    file.append(std::string(2000, 'x') + "\n");
  } catch(const Failure& failure) {
    std::_Exit(static_cast<int>(failure.code()));
  }
  std::_Exit(0);
}

// What there is no room for is not there in part.
TEST(Growing_file_DeathTest, has_whole_lines_on_a_full_disk) {
  const Temporary_folder folder;
  EXPECT_EXIT(write_too_much(folder.path("a.csv")),
              testing::ExitedWithCode(static_cast<int>(Exit_code::WRONG_USAGE)), "");
  EXPECT_EQ(folder.read("a.csv"), "short\n");
}
#endif

TEST(Line_files, go_on_with_whole_meshes_wherever_they_were_cut_off) {
  const std::string first = rows_about("a.off"), second = rows_about("b, \"c\".off");
  const std::string whole = header + first + second;
  for(std::size_t size = 0; size <= whole.size(); ++size) {
    const Temporary_folder folder;
    folder.write("a.csv", whole.substr(0, size));
    Line_files files(folder.path("a.csv"), "", Row_kind::PAIRS);
    files.resume();
    EXPECT_EQ(files.has("b, \"c\".off"), size == whole.size()) << size;
    // Nothing that follows the newline of its row looks like another row of the same mesh.
    EXPECT_EQ(files.has("a.off"), size >= header.size() + first.size()) << size;
    files.add(line_about("a.off"));
    files.add(line_about("b, \"c\".off"));
    EXPECT_EQ(folder.read("a.csv"), whole) << size;
  }
}

TEST(Line_files, make_all_rows_of_a_mesh_again_one_of_which_was_cut_off) {
  const Temporary_folder folder;
  folder.write("a.csv", header + "a.off,0,\na.off,1,\nb.off,0,\nb.off,1,\nb.off,2");
  Line_files files(folder.path("a.csv"), "", Row_kind::PAIRS);
  files.resume();
  EXPECT_TRUE(files.has("a.off"));
  EXPECT_FALSE(files.has("b.off"));
  EXPECT_EQ(folder.read("a.csv"), header + "a.off,0,\na.off,1,\n");
}

TEST(Line_files, tell_where_nothing_is_told_yet) {
  const Temporary_folder folder;
  folder.write("a.csv", header + rows_about("a.off"));
  folder.write("a.jsonl", "{\"mesh\": \"b.off\"}\n{\"mesh\": \"a.");
  Line_files files(folder.path("a.csv"), folder.path("a.jsonl"), Row_kind::PAIRS);
  files.resume();
  for(const std::string mesh : {"a.off", "b.off"}) {
    EXPECT_FALSE(files.has(mesh));
    files.add(line_about(mesh));
    EXPECT_TRUE(files.has(mesh));
  }
  EXPECT_EQ(folder.read("a.csv"), header + rows_about("a.off") + rows_about("b.off"));
  const std::string objects = folder.read("a.jsonl");
  EXPECT_EQ(objects.find("{\"mesh\": \"b.off\"}\n{"), 0u);
  EXPECT_NE(objects.find("\"a.off\""), std::string::npos);
}

TEST(Line_files, refuse_other_columns_and_leave_them) {
  const Temporary_folder folder;
  folder.write("a.csv", "mesh,other\na.off,1\n");
  Line_files files(folder.path("a.csv"), "", Row_kind::PAIRS);
  EXPECT_THROW(files.resume(), Failure);
  EXPECT_EQ(folder.read("a.csv"), "mesh,other\na.off,1\n");
}

} // namespace test_htloops_growing_file
