#include "io/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <new>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

ChildResult run(const std::function<void(const ChildSend&)>& work, const ChildLimits& limits = {}) {
  return runInChild(work, limits);
}

TEST(RunInChild, HandsOverWhatTheChildSends) {
  const std::string large(5 << 20, 'x');
  const ChildResult result = run([&](const ChildSend& send) {
    send("ab", 2);
    send(large.data(), large.size());
  });
  EXPECT_EQ(result.end, ChildEnd::Finished);
  EXPECT_EQ(result.output, "ab" + large);
}

TEST(RunInChild, KeepsCrashesAndExceptionsOutOfThisProcess) {
  EXPECT_EQ(run([](const ChildSend&) { std::raise(SIGSEGV); }).end, ChildEnd::Crashed);
  EXPECT_EQ(run([](const ChildSend&) { std::abort(); }).end, ChildEnd::Crashed);
  EXPECT_EQ(run([](const ChildSend&) { throw InvalidInput("no"); }).end, ChildEnd::Crashed);
  EXPECT_EQ(run([](const ChildSend&) { throw std::bad_alloc(); }).end, ChildEnd::OutOfMemory);
}

TEST(RunInChild, StopsAChildThatTakesTooLong) {
  ChildLimits limits;
  limits.cpuSeconds = 1.0;
  volatile int never = 0;
  EXPECT_EQ(run(
                [&](const ChildSend&) {
                  while (never == 0) never = 0;
                },
                limits)
                .end,
            ChildEnd::OutOfTime);
  limits.wallSeconds = 0.2;
  EXPECT_EQ(run([](const ChildSend&) { ::pause(); }, limits).end, ChildEnd::OutOfTime);
}

TEST(RunInChild, StopsAChildThatTakesTooMuchMemory) {
  ChildLimits limits;
  limits.memoryBytes = 64 << 20;
  const ChildResult result = run(
      [](const ChildSend&) {
        std::vector<std::vector<char>> blocks;
        blocks.reserve(512);
        for (int i = 0; i < 512; ++i) blocks.emplace_back(1 << 20, 'x');
      },
      limits);
  EXPECT_EQ(result.end, ChildEnd::OutOfMemory);
}

TEST(RunInChild, StopsWhenCancelled) {
  std::stop_source stop;
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token(), 1);
  EXPECT_THROW(static_cast<void>(runInChild([](const ChildSend&) { ::pause(); }, {}, progress)), Cancelled);
}

}  // namespace
}  // namespace vantage
