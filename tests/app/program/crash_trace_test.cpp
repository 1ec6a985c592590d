#include "program/crash_trace.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "app/program/breaking_program.h"
#include "program/version.h"
#include "support/test_data.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

class CrashTraceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "programs with a sanitizer leave crashes to it";
  }
  [[nodiscard]] fs::path folder() const { return temporary_.file("state/vantage/crashes"); }

  testing::TemporaryFolder temporary_;
};

// Not to be seen through by the compiler.
void writeNowhere() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}

TEST_F(CrashTraceTest, AFaultLeavesSignalSessionAndStackAndEndsTheProgramByIt) {
  EXPECT_EQ(testing::endOfProgram("vantage", folder(), "/home/a/mug.vantage", writeNowhere), SIGSEGV);
  const auto crash = untoldCrash("vantage", folder());
  ASSERT_TRUE(crash);
  EXPECT_EQ(crash->session, "/home/a/mug.vantage");
  EXPECT_NE(crash->text.find("program: vantage " + programVersion() + "\ncommit: " + programCommit() + "\n"),
            std::string::npos);
  EXPECT_NE(crash->text.find("signal: SIGSEGV at 0x0\n"), std::string::npos);
  const std::size_t stack = crash->text.find("stack:\n");
  const std::size_t memory = crash->text.find("memory:\n");
  ASSERT_LT(stack, memory);
  // The handler, the fault, and what called it: all of this program.
  const std::string frames = crash->text.substr(stack, memory - stack);
  EXPECT_GT(std::count(frames.begin(), frames.end(), '\n'), 4);
  EXPECT_NE(frames.find("test_program"), std::string::npos);
  EXPECT_NE(crash->text.find("[stack]", memory), std::string::npos);
}

TEST_F(CrashTraceTest, AnExceptionThatNobodyCaughtIsInIt) {
  const auto throwing = []() noexcept { throw std::runtime_error("the table fell over"); };
  EXPECT_EQ(testing::endOfProgram("vantage", folder(), "", throwing), SIGABRT);
  const auto crash = untoldCrash("vantage", folder());
  ASSERT_TRUE(crash);
  EXPECT_NE(crash->text.find("exception: the table fell over\n"), std::string::npos);
  EXPECT_EQ(crash->session, "");
}

// Deeper than any stack: the handler has one of its own.
int deepen(volatile int depth) {
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return depth < 0 ? room[0] : deepen(depth + 1) + room[0];
}

TEST_F(CrashTraceTest, AStackThatIsFullLeavesOneToo) {
  EXPECT_EQ(testing::endOfProgram("vantage", folder(), "", [] { static_cast<void>(deepen(0)); }), SIGSEGV);
  EXPECT_TRUE(untoldCrash("vantage", folder()));
}

TEST_F(CrashTraceTest, IsToldOnceAndStays) {
  testing::endOfProgram("vantage", folder(), "s", [] { std::abort(); });
  const auto crash = untoldCrash("vantage", folder());
  ASSERT_TRUE(crash);
  EXPECT_FALSE(untoldCrash("vantage-cli", folder())) << "it is of another program";
  tellCrashes("vantage", folder());
  EXPECT_FALSE(untoldCrash("vantage", folder()));
  EXPECT_TRUE(fs::exists(fs::path(crash->file).replace_extension(".txt")));
}

TEST_F(CrashTraceTest, OfTheCommandLineIsNoneOfTheWindow) {
  testing::endOfProgram("vantage-cli", folder(), "", [] { std::abort(); });
  EXPECT_FALSE(untoldCrash("vantage", folder()));
  EXPECT_TRUE(untoldCrash("vantage-cli", folder()));
}

TEST_F(CrashTraceTest, NothingIsLeftWhereNothingBroke) {
  EXPECT_EQ(testing::endOfProgram("vantage", folder(), "s", [] {}), 0);
  EXPECT_FALSE(fs::exists(folder()));
  EXPECT_FALSE(untoldCrash("vantage", folder()));
}

}  // namespace
}  // namespace vantage
