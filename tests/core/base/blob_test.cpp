#include "base/blob.h"

#include <gtest/gtest.h>

#include <array>

namespace vantage {
namespace {

std::vector<std::byte> example() {
  BlobWriter writer;
  writer.value(std::int16_t{-2});
  writer.list(std::vector<std::array<float, 2>>{{1.0F, 2.0F}, {3.0F, 4.0F}});
  writer.list(std::vector<double>{});
  return writer.bytes();
}

TEST(Blob, AListIsItsCountAndItsItems) {
  EXPECT_EQ(example().size(), 2U + (8U + 16U) + 8U);
}

TEST(Blob, WhatIsReadIsWhatWasWritten) {
  const auto bytes = example();
  BlobReader reader(bytes, "example");
  EXPECT_EQ(reader.value<std::int16_t>(), -2);
  EXPECT_EQ((reader.list<std::array<float, 2>>()), (std::vector<std::array<float, 2>>{{1.0F, 2.0F}, {3.0F, 4.0F}}));
  EXPECT_TRUE(reader.list<double>().empty());
  EXPECT_NO_THROW(reader.finish());
}

TEST(Blob, NothingIsReadBeyondTheEnd) {
  const auto bytes = example();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    BlobReader reader(std::span<const std::byte>(bytes).first(size), "example");
    auto readAll = [&] {
      (void)reader.value<std::int16_t>();
      (void)reader.list<std::array<float, 2>>();
      (void)reader.list<double>();
    };
    EXPECT_THROW(readAll(), InvalidInput) << size << " bytes";
  }
}

TEST(Blob, ACountThatNoMemoryHoldsIsRefused) {
  BlobWriter writer;
  writer.value(~std::uint64_t{0});
  BlobReader reader(writer.bytes(), "example");
  EXPECT_THROW((void)reader.list<double>(), InvalidInput);
}

TEST(Blob, WhatIsLeftOverIsNoticed) {
  const auto bytes = example();
  BlobReader reader(bytes, "example");
  (void)reader.value<std::int16_t>();
  EXPECT_THROW(reader.finish(), InvalidInput);
}

}  // namespace
}  // namespace vantage
