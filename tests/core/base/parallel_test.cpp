#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/random.h"

namespace vantage {
namespace {

Progress onThreads(int threads) {
  return {{}, {}, threads};
}

using Chunks = std::set<std::pair<std::size_t, std::size_t>>;

Chunks chunksOf(std::size_t count, std::size_t grain, int threads) {
  Chunks chunks;
  std::mutex mutex;
  parallelChunks(count, grain, onThreads(threads), [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(chunks.emplace(begin, end).second);
  });
  return chunks;
}

TEST(ParallelChunks, CoverTheRangeWithoutOverlap) {
  EXPECT_EQ(chunksOf(10, 4, 1), (Chunks{{0, 4}, {4, 8}, {8, 10}}));
  EXPECT_EQ(chunksOf(8, 4, 3), (Chunks{{0, 4}, {4, 8}}));
  EXPECT_EQ(chunksOf(3, 100, 4), (Chunks{{0, 3}}));
  EXPECT_EQ(chunksOf(2, 0, 2), (Chunks{{0, 1}, {1, 2}}));
  EXPECT_TRUE(chunksOf(0, 4, 2).empty());
}

TEST(ParallelChunks, DoNotDependOnTheNumberOfThreads) {
  for (const int threads : {2, 3, 8}) EXPECT_EQ(chunksOf(1001, 17, threads), chunksOf(1001, 17, 1));
}

// A sum of floating point numbers shows the order of its terms.
double chunkedSum(int threads) {
  constexpr std::size_t kCount = 20000;
  constexpr std::size_t kGrain = 64;
  std::vector<double> partial((kCount + kGrain - 1) / kGrain, 0.0);
  parallelChunks(kCount, kGrain, onThreads(threads), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) partial[begin / kGrain] += Random(1, i).normal();
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

TEST(ParallelChunks, OneSlotPerChunkGivesTheSameBytesForAnyNumberOfThreads) {
  const double expected = chunkedSum(1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(chunkedSum(threads), expected);
}

TEST(ParallelChunks, AnExceptionOfTheBodyReachesTheCaller) {
  for (const int threads : {1, 4}) {
    try {
      parallelChunks(100, 1, onThreads(threads), [](std::size_t begin, std::size_t /*end*/) {
        if (begin == 37) throw InvalidInput("item 37");
      });
      FAIL() << "nothing was thrown on " << threads << " threads";
    } catch (const InvalidInput& e) {
      EXPECT_STREQ(e.what(), "item 37");
    }
  }
}

TEST(ParallelChunks, TheLowestFailingChunkWinsWhenAllFail) {
  for (int run = 0; run < 20; ++run) {
    try {
      parallelChunks(64, 1, onThreads(4),
                     [](std::size_t begin, std::size_t /*end*/) { throw InvalidInput(std::to_string(begin)); });
      FAIL();
    } catch (const InvalidInput& e) {
      EXPECT_STREQ(e.what(), "0");
    }
  }
}

TEST(ParallelChunks, StopAfterAFailure) {
  std::atomic<int> calls{0};
  EXPECT_THROW(parallelChunks(100000, 1, onThreads(2),
                              [&](std::size_t /*begin*/, std::size_t /*end*/) {
                                ++calls;
                                throw InvalidInput("at once");
                              }),
               InvalidInput);
  EXPECT_LE(calls.load(), 2);
}

TEST(ParallelChunks, CancelBeforeTheFirstChunkRunsNothing) {
  std::stop_source source;
  source.request_stop();
  bool ran = false;
  EXPECT_THROW(parallelChunks(10, 1, Progress({}, source.get_token(), 2),
                              [&](std::size_t /*begin*/, std::size_t /*end*/) { ran = true; }),
               Cancelled);
  EXPECT_FALSE(ran);
}

TEST(ParallelChunks, CancelInTheMiddleEndsTheLoop) {
  for (const int threads : {1, 3}) {
    std::stop_source source;
    std::atomic<int> calls{0};
    EXPECT_THROW(parallelChunks(100000, 1, Progress({}, source.get_token(), threads),
                                [&](std::size_t /*begin*/, std::size_t /*end*/) {
                                  if (++calls == 5) source.request_stop();
                                }),
                 Cancelled);
    EXPECT_LT(calls.load(), 5 + threads);
  }
}

TEST(ParallelChunks, ReportsProgressOfTheirPart) {
  std::vector<double> fractions;
  const Progress progress([&](double fraction, std::string_view /*step*/) { fractions.push_back(fraction); }, {}, 1);
  parallelChunks(4, 1, progress.part(0.5, 1.0), [](std::size_t /*begin*/, std::size_t /*end*/) {});
  EXPECT_EQ(fractions, (std::vector<double>{0.5, 0.5, 0.625, 0.75, 0.875}));
}

}  // namespace
}  // namespace vantage
