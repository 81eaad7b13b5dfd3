#include "htloops/write/html_page.h"

#include "Temporary_folder.h"

#include <gtest/gtest.h>

using namespace htloops;

namespace {

// The examples of RFC 4648.
TEST(Html_page, PicturesAreWrittenInBase64) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of("\xff\xfe\xfd"), "//79");
}

TEST(Html_page, TextsAreNoMarkup) {
  EXPECT_EQ(html_of("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;");
  const Temporary_folder folder;
  Html_page page(folder.path("page.html"), "<script>");
  page.paragraph("1 < 2");
  page.picture("", "no picture");
  page.picture("f", "\"<b>\"");
  page.table({{"name", "<n>"}, {"&", "1"}}, 1, 2);
  page.finish();
  const std::string text = folder.read("page.html");
  EXPECT_EQ(text.find("<script"), std::string::npos);
  EXPECT_EQ(text.find("no picture"), std::string::npos);
  for(const char* expected :
      {"<p>1 &lt; 2</p>", "alt=\"&quot;&lt;b&gt;&quot;\" src=\"data:image/png;base64,Zg==\"",
       "<tr><th>name</th><th class=\"n\">&lt;n&gt;</th></tr>",
       "<tr><td>&amp;</td><td class=\"n\">1</td></tr>"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
}

} // namespace
