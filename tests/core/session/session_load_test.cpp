#include <gtest/gtest.h>
#include <malloc.h>

#include "large_session.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// Bytes that the program has asked for and not given back.
std::size_t bytesInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(SessionLoad, OfManyViewsOnlyWhatIsShownIsInMemory) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("large.vantage");
  testing::writeLargeSession(path, 60);

  const std::size_t before = bytesInUse();
  const Session session = Session::open(path, SessionAccess::Read);
  ASSERT_EQ(session.history().size(), 61U);
  EXPECT_EQ(countScans(*session.history().current().outline, ScanStatus::In), 60U);
  const std::size_t opened = bytesInUse() - before;
  const auto shown = session.scan(30);
  const std::size_t one = bytesInUse() - before - opened;
  // 60 scans of 67,600 samples are 16 MB before anything is made of them; one is 0.27 MB, and 3.3 MB the rays of all.
  EXPECT_LT(opened, 12U << 20);
  EXPECT_LT(one, 5U << 20);
  const std::size_t two = bytesInUse();
  const auto other = session.scan(31);
  EXPECT_LT(bytesInUse() - two, 1U << 20);
}

}  // namespace
}  // namespace vantage
