#include "io/xml_scanner.h"

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

TEST(XmlScanner, WalksOverTags) {
  XmlScanner xml(
      "<?xml version='1.0'?>\n<!-- <no> -->\n<m:model unit = \"mm\" xmlns:p='x' "
      "p:path='/a>b'>text<a/><![CDATA[<no>]]></m:model>\n",
      "f", "p");
  XmlTag tag;
  ASSERT_TRUE(xml.next(tag));
  EXPECT_EQ(tag.name, "model");
  EXPECT_TRUE(tag.opens && !tag.closes);
  EXPECT_EQ(tag.attribute("unit"), "mm");
  EXPECT_EQ(tag.attribute("path"), "/a>b");
  EXPECT_EQ(tag.attribute("xmlns:p"), "x");
  EXPECT_EQ(tag.attribute("other"), "");
  ASSERT_TRUE(xml.next(tag));
  EXPECT_EQ(tag.name, "a");
  EXPECT_TRUE(tag.opens && tag.closes);
  ASSERT_TRUE(xml.next(tag));
  EXPECT_EQ(tag.name, "model");
  EXPECT_TRUE(!tag.opens && tag.closes);
  EXPECT_FALSE(xml.next(tag));
}

TEST(XmlScanner, RefusesWhatIsNotWellFormedByLine) {
  auto refuse = [](const std::string& text, const std::vector<std::string>& parts) {
    expectError<InvalidInput>(
        [&] {
          XmlScanner xml(text, "file", "part");
          for (XmlTag tag; xml.next(tag);) EXPECT_FALSE(tag.name.empty());
        },
        parts);
  };
  refuse("<a>\n<b>", {"file: part, line 2", "'b'", "truncated"});
  refuse("<a>\n<b x='1", {"line 2", "truncated"});
  refuse("<a>\n<b x='1'", {"'b'", "truncated"});
  refuse("garbage", {"no XML", "encrypted"});
  refuse("", {"no XML"});
  refuse("<a></b>", {"'b'", "no beginning"});
  refuse("</a>", {"'a'", "no beginning"});
  refuse("<a x>", {"'x'", "no value"});
  refuse("<a x=1>", {"'x'", "quotes"});
  refuse("<a <b>", {"a name was expected"});
  refuse("<>", {"a name was expected"});
  refuse("<!-- no end", {"truncated"});
  refuse("<!DOCTYPE a [<!ENTITY b 'bbb'>]><a/>", {"document type"});
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "<a>";
  refuse(deep, {"256 deep"});
}

TEST(XmlScanner, ReplacesEntities) {
  EXPECT_EQ(withoutEntities("&lt;a&amp;b&gt; &quot;&apos;&x;"), "<a&b> \"'&x;");
}

}  // namespace
}  // namespace vantage
