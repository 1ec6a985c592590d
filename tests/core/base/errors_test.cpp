#include "base/errors.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(Errors, IoErrorLeadsWithThePath) {
  EXPECT_STREQ(IoError("scans/mug.ply", "cannot be opened").what(), "scans/mug.ply: cannot be opened");
}

TEST(Errors, AllAreCaughtAsError) {
  EXPECT_THROW(throw InvalidInput("x"), Error);
  EXPECT_THROW(throw IoError("x", "y"), Error);
  EXPECT_THROW(throw DeviceError("x"), Error);
  EXPECT_THROW(throw Cancelled(), Error);
}

}  // namespace
}  // namespace vantage
