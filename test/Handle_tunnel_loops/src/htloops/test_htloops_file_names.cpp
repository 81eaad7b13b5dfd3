#include "app/file_names.h"

#include "Temporary_folder.h"

#include "app/read/mesh_list.h"
#include "app/write/rows.h"

#include <gtest/gtest.h>

#include <string>

namespace test_htloops_file_names {

using namespace htloops;
using Names = std::vector<std::string>;

TEST(Printable, leaves_harmless_names_alone) {
  for(const std::string name : {"mesh.off", "a b&c.off", "M\xC3\xBCtze.off", "C:\\mesh.off",
                                "\xE7\xAF\x80.off", "\xF0\x9F\x8D\xA9.off"})
  {
    EXPECT_EQ(printable(name), name);
    EXPECT_EQ(as_utf8(name), name);
  }
}

TEST(Printable, writes_out_what_a_terminal_obeys_once) {
  const std::string name = "a\n\t\x1B[31m\x7F\xC2\x9B\xE2\x80\xAE.off";
  const std::string text = "a\\n\\t\\x1B[31m\\x7F\\u009B\\u202E.off";
  EXPECT_EQ(printable(name), text);
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(as_utf8(name), name);
  EXPECT_EQ(printable_lines("a\nb\x1B"), "a\nb\\x1B");
}

TEST(Printable, writes_out_bytes_that_are_no_characters) {
  // Of Latin-1; cut off; longer than need be; half of a pair; a byte that never is.
  EXPECT_EQ(printable("\xE9.off"), "\\xE9.off");
  EXPECT_EQ(printable("a\xC3"), "a\\xC3");
  EXPECT_EQ(printable("\xC0\xAF"), "\\xC0\\xAF");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80");
  EXPECT_EQ(as_utf8("\xFF\n"), "\\xFF\n");
}

TEST(As_cell, is_no_formula_and_on_one_line) {
  for(const char sign : {'=', '+', '-', '@'})
    EXPECT_EQ(as_cell(sign + std::string("1")), '\'' + (sign + std::string("1")));
  EXPECT_EQ(as_cell("a=b"), "a=b");
  EXPECT_EQ(as_cell("=\"a\",b"), "\"'=\"\"a\"\",b\"");
  EXPECT_EQ(as_cell("a\r\nb"), "a\\r\\nb");
}

TEST(Mesh_list, has_what_folders_and_patterns_stand_for) {
  const Temporary_folder folder;
  std::filesystem::create_directories(folder.path("scans/deeper.off"));
  for(const std::string name : {"b.off", "a.PLY", "c.txt", "[a].stl"})
    folder.write("scans/" + name, "");
  const std::string scans = folder.path("scans");
  const Names meshes = {scans + "/[a].stl", scans + "/a.PLY", scans + "/b.off"};
  EXPECT_EQ(files_of(scans), meshes);
  EXPECT_EQ(files_of(Names{scans, scans + "/a.PLY", "other"}),
            (Names{meshes[0], meshes[1], meshes[2], "other"}));
  EXPECT_EQ(files_of(scans + "/[a].stl"), Names{meshes[0]});
  EXPECT_EQ(files_of(folder.path("none*")), Names{folder.path("none*")});
  EXPECT_TRUE(may_be_many({scans}));
  EXPECT_TRUE(may_be_many({folder.path("none*")}));
  EXPECT_FALSE(may_be_many({scans + "/[a].stl"}));
#if __has_include(<glob.h>)
  EXPECT_EQ(files_of(scans + "/[bc].*"), (Names{scans + "/b.off", scans + "/c.txt"}));
#endif
}

} // namespace test_htloops_file_names
