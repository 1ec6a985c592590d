#include "base/content_hash.h"

#include <gtest/gtest.h>

#include <set>

namespace vantage {
namespace {

// What splitmix64 draws first from the state 0.
TEST(MixedBits, IsTheFinaliserOfSplitmix64) {
  EXPECT_EQ(mixedBits(0x9e3779b97f4a7c15ULL), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(mixedBits(0), 0U);
}

// Written down from session files: these numbers must never change.
TEST(ContentHash, ValuesAreThoseThatFilesHold) {
  ContentHash hash;
  EXPECT_EQ(hash.value(), 0xe220a8397b1dcdafULL);
  hash.add(std::string_view("mug"));
  hash.add(true);
  hash.add(-7);
  hash.add(0.25);
  hash.add(std::vector<float>{1.5F, -2.0F, 3.0F});
  EXPECT_EQ(hash.value(), 0x543856c7df40bce7ULL);
  hash.add(std::string_view(""));
  EXPECT_EQ(hash.value(), 0xfdbd2cf72478c8e2ULL);
}

TEST(ContentHash, EveryByteAndEveryBorderBetweenItemsCounts) {
  std::set<std::uint64_t> values;
  const std::string text(19, 'a');
  auto insert = [&](std::string_view first, std::string_view second) {
    ContentHash hash;
    hash.add(first);
    hash.add(second);
    values.insert(hash.value());
  };
  for (std::size_t cut = 0; cut <= text.size(); ++cut)
    insert(std::string_view(text).substr(0, cut), std::string_view(text).substr(cut));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = 'b';
    insert(other, "");
  }
  EXPECT_EQ(values.size(), 2 * text.size() + 1);
}

TEST(ContentHash, GoesBackWhereTheLastValueIsKnown) {
  ContentHash hash;
  hash.add("the settings");
  const std::uint64_t then = hash.value();
  hash.add(7);
  const int last = 7;
  EXPECT_EQ(ContentHash::before(hash.value(), std::as_bytes(std::span(&last, 1))).value(), then);
}

TEST(ContentHash, TextIsSixteenDigits) {
  EXPECT_EQ(hashText(0x0123456789abcdefULL), "0123456789abcdef");
  EXPECT_EQ(hashText(0), "0000000000000000");
}

}  // namespace
}  // namespace vantage
