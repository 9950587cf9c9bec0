#include "base/parallel.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace saddle {
namespace {

using Chunks = std::set<std::pair<std::size_t, std::size_t>>;

Chunks chunks_of(std::size_t count, std::size_t chunk, unsigned threads) {
  Chunks chunks;
  std::mutex mutex;
  parallel_chunks(count, chunk, threads, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(chunks.emplace(begin, end).second) << "chunk at " << begin << " twice";
  });
  return chunks;
}

TEST(ParallelChunks, CoverTheRangeTheSameWayForAnyNumberOfThreads) {
  const Chunks expected = {{0, 4}, {4, 8}, {8, 11}};
  for (const unsigned threads : {0u, 1u, 2u, 3u, 64u}) {
    EXPECT_EQ(chunks_of(11, 4, threads), expected) << threads << " threads";
  }
}

TEST(ParallelChunks, HandleTheEdgesOfTheRange) {
  EXPECT_EQ(chunks_of(0, 4, 2), Chunks{});
  EXPECT_EQ(chunks_of(1, 4, 2), (Chunks{{0, 1}}));
  EXPECT_EQ(chunks_of(8, 4, 2), (Chunks{{0, 4}, {4, 8}}));
  EXPECT_EQ(chunks_of(3, static_cast<std::size_t>(-1), 2), (Chunks{{0, 3}}));
}

TEST(ParallelChunks, VisitEveryIndexOnce) {
  std::vector<std::atomic<int>> visits(10007);
  parallel_chunks(visits.size(), 3, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  for (const std::atomic<int>& count : visits) EXPECT_EQ(count, 1);
}

TEST(ParallelChunks, StayOnTheCallingThreadWhereOneIsEnough) {
  const std::thread::id here = std::this_thread::get_id();
  const auto expect_here = [here](std::size_t, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), here);
  };
  parallel_chunks(100, 1, 1, expect_here);
  parallel_chunks(100, 100, 8, expect_here);
}

TEST(ParallelChunks, RunAtTheSameTime) {
  // Each chunk waits for the other: one thread alone would never end.
  std::atomic<int> arrived = 0;
  parallel_chunks(2, 1, 2, [&](std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(ParallelChunks, RunOnNoMoreThreadsThanAsked) {
  // Many threads wait for loops by now.
  parallel_chunks(16, 1, 16, [](std::size_t, std::size_t) {});
  for (int k = 0; k < 20; ++k) {
    std::set<std::thread::id> threads;
    std::mutex mutex;
    parallel_chunks(64, 1, 3, [&](std::size_t, std::size_t) {
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
    EXPECT_LE(threads.size(), 3);
  }
}

TEST(ParallelChunks, EndWhereLoopsStartOthersOnAllThreads) {
  std::atomic<int> visits = 0;
  parallel_chunks(8, 1, 4, [&](std::size_t, std::size_t) {
    parallel_chunks(8, 1, 4, [&](std::size_t, std::size_t) {
      parallel_chunks(8, 1, 4, [&](std::size_t, std::size_t) { ++visits; });
    });
  });
  EXPECT_EQ(visits, 512);
}

TEST(ParallelChunks, RethrowABodysExceptionOnceAllThreadsHaveEnded) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<int> running = 0;
    try {
      parallel_chunks(100, 1, threads, [&](std::size_t begin, std::size_t) {
        ++running;
        std::this_thread::yield();
        --running;
        if (begin == 10) throw std::runtime_error("chunk 10");
      });
      FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "chunk 10");
      EXPECT_EQ(running, 0);
    }
  }
}

TEST(ParallelChunks, StopOnAllThreadsAfterAnException) {
  // The other thread waits for the exception, then works slowly: a second for all of its chunks,
  // where the exception needs microseconds to reach the loop.
  std::atomic<bool> thrown = false;
  std::atomic<int> calls = 0;
  const auto body = [&](std::size_t begin, std::size_t) {
    ++calls;
    if (begin == 0) {
      thrown = true;
      throw std::runtime_error("first");
    }
    while (!thrown) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_THROW(parallel_chunks(1000, 1, 2, body), std::runtime_error);
  EXPECT_LT(calls, 1000);
}

TEST(GatherInChunks, KeepsTheOrderOnAnyNumberOfThreads) {
  const auto gather = [](std::size_t count, unsigned threads) {
    return gather_in_chunks<std::size_t>(count, 4, threads,
                                         [](std::size_t k, std::vector<std::size_t>& found) {
                                           if (k % 3 > 0) found.push_back(k);
                                         });
  };
  for (const unsigned threads : {0u, 1u, 3u}) {
    EXPECT_EQ(gather(0, threads), std::vector<std::size_t>{});
    EXPECT_EQ(gather(4, threads), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(gather(9, threads), (std::vector<std::size_t>{1, 2, 4, 5, 7, 8}));
  }
}

TEST(AvailableThreads, CountTheProcessorsThatTheProcessMayUse) {
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(available_threads(), static_cast<unsigned>(CPU_COUNT(&before)));
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(available_threads(), 1u);
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

TEST(Abandonable, EndsLoopsOfItsThreadOnceItIsAskedTo) {
  std::stop_source source;
  int chunks = 0;
  const auto count_and_stop = [&](std::size_t, std::size_t) {
    if (++chunks == 3) source.request_stop();
  };
  {
    const Abandonable abandonable(source.get_token());
    EXPECT_THROW(parallel_chunks(100, 1, 1, count_and_stop), Abandoned);
    EXPECT_EQ(chunks, 3);
    EXPECT_THROW(parallel_chunks(100, 1, 1, count_and_stop), Abandoned) << "a later loop";
    EXPECT_EQ(chunks, 3);
  }
  parallel_chunks(10, 1, 1, count_and_stop);
  EXPECT_EQ(chunks, 13) << "nobody asks any more";
}

}  // namespace
}  // namespace saddle
