// Patterns of names, as shells have them, on all systems.

#include "app/read/patterns.h"
#include "app/system/files.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace test_htloops_patterns {

using htloops::fits;
using htloops::names_fitting;

TEST(Patterns, stand_for_names) {
  EXPECT_TRUE(fits("", ""));
  EXPECT_TRUE(fits("", "*"));
  EXPECT_FALSE(fits("", "?"));
  EXPECT_TRUE(fits("cup.off", "cup.off"));
  EXPECT_FALSE(fits("cup.off", "cup.of"));
  EXPECT_FALSE(fits("cup.of", "cup.off"));
  EXPECT_TRUE(fits("cup.off", "*.off"));
  EXPECT_TRUE(fits("cup.off.off", "*.off"));
  EXPECT_FALSE(fits("cup.off.gz", "*.off"));
  EXPECT_TRUE(fits("abcabcabd", "*abc*abd"));
  EXPECT_FALSE(fits("abcabcab", "*abc*abd"));
  EXPECT_TRUE(fits("cup", "c?p"));
  EXPECT_FALSE(fits("cp", "c?p"));
  EXPECT_FALSE(fits(std::string(10000, 'a'), "*a*a*a*a*a*a*a*a*b"));
}

TEST(Patterns, have_brackets) {
  EXPECT_TRUE(fits("b", "[abc]"));
  EXPECT_TRUE(fits("b", "[a-c]"));
  EXPECT_FALSE(fits("d", "[a-c]"));
  EXPECT_TRUE(fits("d", "[!a-c]"));
  EXPECT_TRUE(fits("d", "[^a-c]"));
  EXPECT_FALSE(fits("b", "[!a-c]"));
  EXPECT_TRUE(fits("-", "[a-]"));
  EXPECT_TRUE(fits("]", "[]a]"));
  EXPECT_FALSE(fits("]", "[!]a]"));
  EXPECT_TRUE(fits("x7.off", "*[0-9].off"));
  EXPECT_TRUE(fits("[", "["));
  EXPECT_TRUE(fits("[a", "[a"));
  EXPECT_FALSE(fits("a", "[a"));
  EXPECT_FALSE(fits("", "[a]"));
}

class Folder : public testing::Test
{
protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    for(const char* name : {"b.off", "a.off", ".c.off", "d.ply"})
      for(const char* below : {"", "one/", "two/", "two/gr\xC3\xBC\xC3\x9F/"}) {
        std::filesystem::create_directories(htloops::path_of(folder_ + "/" + below));
        std::fclose(htloops::open(folder_ + "/" + below + name, "wbx"));
      }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::vector<std::string> found(const std::string& pattern) const {
    std::vector<std::string> names = names_fitting(folder_ + "/" + pattern);
    for(std::string& name : names)
      name.erase(0, folder_.size() + 1);
    return names;
  }

  const std::string folder_ =
      htloops::name_of_path(std::filesystem::temp_directory_path() / "htloops_patterns");
};

using Names = std::vector<std::string>;

TEST_F(Folder, has_names_that_fit) {
  EXPECT_EQ(found("*.off"), (Names{"a.off", "b.off"}));
  EXPECT_EQ(found(".*.off"), Names{".c.off"});
  EXPECT_EQ(found("one/[b-z]*"), (Names{"one/b.off", "one/d.ply"}));
  EXPECT_EQ(found("*/a.off"), (Names{"one/a.off", "two/a.off"}));
  EXPECT_EQ(found("t*/*/?.ply"), Names{"two/gr\xC3\xBC\xC3\x9F/d.ply"});
  EXPECT_EQ(found("*/"), (Names{"one/", "two/"}));
  EXPECT_EQ(found("a.off"), Names{"a.off"});
  EXPECT_EQ(found("*.stl"), Names{});
  EXPECT_EQ(found("none/*.off"), Names{});
  EXPECT_EQ(found("a.off/*"), Names{});
}

TEST_F(Folder, has_a_file_once) {
  EXPECT_EQ(htloops::open(folder_ + "/a.off", "wbx"), nullptr);
  std::FILE* const file = htloops::open(folder_ + "/a.off", "rb");
  ASSERT_NE(file, nullptr);
  std::fclose(file);
}

} // namespace test_htloops_patterns
