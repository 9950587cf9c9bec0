// The newest request counts: what is shown last is what was wished for last.
#include "view/model/mesh_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "base/parallel.h"

namespace saddle {
namespace {

Scene titled_scene(const std::string& title) {
  Scene scene;
  scene.title = title;
  scene.surfaces.resize(1);
  scene.surfaces[0].label = title;  // a mesh of its own
  return scene;
}

/// Waits for results, which a worker announces.
class Results {
 public:
  void announce() {
    const std::lock_guard lock(mutex_);
    ++announced_;
    changed_.notify_one();
  }
  /// The next one that is no preview, of the scene with this title.
  Meshed wait_for(MeshWorker& worker, const std::string& title) {
    while (true) {
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return announced_ > 0; });
        --announced_;
      }
      auto result = worker.take();
      if (result && !result->preview && result->scene.title == title) return std::move(*result);
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int announced_ = 0;
};

/// Work that only ends by being abandoned.
void work_for_ever() {
  while (true) parallel_chunks(1, 1, 1, [](std::size_t, std::size_t) {});
}

TEST(MeshWorker, MeshesWhatIsWishedForLast) {
  Results results;
  std::atomic<int> previews = 0;
  MeshWorker worker(
      [&](const Scene&, std::size_t, Detail detail) {
        previews += detail == Detail::Preview ? 1 : 0;
        return Tessellation{};
      },
      [&] { results.announce(); });
  for (int i = 0; i < 100; ++i)
    worker.request(titled_scene(std::to_string(i)), Manner::PreviewFirst);
  EXPECT_EQ(results.wait_for(worker, "99").surfaces.size(), 1U);
  EXPECT_GE(previews, 1);
  EXPECT_LE(previews, 100);
}

TEST(MeshWorker, MakesNoPreviewOfWhatIsQuick) {
  Results results;
  std::atomic<int> previews = 0;
  std::atomic<bool> is_slow = false;
  MeshWorker worker(
      [&](const Scene&, std::size_t, Detail detail) {
        if (detail == Detail::Preview) {
          ++previews;
          is_slow = false;
        }
        while (is_slow) parallel_chunks(1, 1, 1, [](std::size_t, std::size_t) {});
        return Tessellation{};
      },
      [&] { results.announce(); });
  worker.request(titled_scene("first"), Manner::Full);
  results.wait_for(worker, "first");
  worker.request(titled_scene("quick"), Manner::PreviewFirst);
  results.wait_for(worker, "quick");
  EXPECT_EQ(previews, 0);
  is_slow = true;
  worker.request(titled_scene("slow"), Manner::PreviewFirst);
  results.wait_for(worker, "slow");
  EXPECT_EQ(previews, 1) << "the real mesh took too long";
}

TEST(MeshWorker, AbandonsWhatTakesForEver) {
  Results results;
  std::atomic<bool> begun = false;
  MeshWorker worker(
      [&](const Scene& scene, std::size_t, Detail) {
        begun = true;
        if (scene.title == "endless") work_for_ever();
        return Tessellation{};
      },
      [&] { results.announce(); });
  worker.request(titled_scene("endless"), Manner::Full);
  while (!begun) std::this_thread::yield();
  worker.request(titled_scene("quick"), Manner::Full);
  EXPECT_FALSE(results.wait_for(worker, "quick").error);
}

TEST(MeshWorker, DoesInTurnWhatMustNotBeAbandoned) {
  Results results;
  std::atomic<int> begun = 0;
  std::atomic<int> may_end = 0;
  MeshWorker worker(
      [&](const Scene&, std::size_t, Detail) {
        const int number = ++begun;
        while (may_end < number) parallel_chunks(1, 1, 1, [](std::size_t, std::size_t) {});
        return Tessellation{};
      },
      [&] { results.announce(); });
  worker.request(titled_scene("first"), Manner::Full);
  while (begun == 0) std::this_thread::yield();
  worker.request(titled_scene("skipped"), Manner::InTurn);
  worker.request(titled_scene("second"), Manner::InTurn);
  may_end = 1;
  EXPECT_FALSE(results.wait_for(worker, "first").error);
  may_end = 2;
  EXPECT_FALSE(results.wait_for(worker, "second").error);
}

TEST(MeshWorker, EndsWhileItWorks) {
  std::atomic<bool> begun = false;
  {
    MeshWorker worker(
        [&](const Scene&, std::size_t, Detail) -> Tessellation {
          begun = true;
          work_for_ever();
          return {};
        },
        [] {});
    worker.request(titled_scene("endless"), Manner::PreviewFirst);
    while (!begun) std::this_thread::yield();
  }
  SUCCEED() << "the destructor returns";
}

TEST(MeshWorker, TellsWhichSurfaceIsWrong) {
  Results results;
  MeshWorker worker(
      [](const Scene&, std::size_t surface, Detail) -> Tessellation {
        if (surface == 1) throw Error(Status::Input, "wrong");
        return {};
      },
      [&] { results.announce(); });
  Scene scene = titled_scene("two");
  scene.surfaces.resize(2);
  worker.request(scene, Manner::PreviewFirst);
  const Meshed result = results.wait_for(worker, "two");
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.faulty_surface, 1U);
  EXPECT_TRUE(result.surfaces.empty());
}

TEST(MeshWorker, TellsNoErrorOfAPreviewAlone) {
  Results results;
  MeshWorker worker(
      [](const Scene&, std::size_t, Detail detail) -> Tessellation {
        if (detail == Detail::Preview) throw Error(Status::Nothing, "nothing on so few samples");
        return {};
      },
      [&] { results.announce(); });
  Scene scene = titled_scene("fine");
  scene.surfaces.resize(1);
  worker.request(scene, Manner::PreviewFirst);
  EXPECT_FALSE(results.wait_for(worker, "fine").error);
}

TEST(MeshWorker, TellsWhatNoErrorIs) {
  Results results;
  MeshWorker worker(
      [](const Scene&, std::size_t, Detail) -> Tessellation { throw std::runtime_error("odd"); },
      [&] { results.announce(); });
  worker.request(titled_scene("odd"), Manner::PreviewFirst);
  const Meshed result = results.wait_for(worker, "odd");
  ASSERT_TRUE(result.error);
  EXPECT_STREQ(result.error->what(), "odd");
  EXPECT_EQ(result.error->status(), Status::Machine);
}

TEST(MeshWorker, MakesAgainOnlyThatWhichHasChanged) {
  Results results;
  std::atomic<int> made = 0;
  MeshWorker worker(
      [&](const Scene&, std::size_t, Detail detail) {
        made += detail == Detail::Full ? 1 : 0;
        return Tessellation{};
      },
      [&] { results.announce(); });
  Scene scene = titled_scene("first");
  scene.surfaces.assign(3, SurfaceSpec());
  for (SurfaceSpec& spec : scene.surfaces) spec.z = "u";
  scene.surfaces[1].z = "v";
  worker.request(scene, Manner::PreviewFirst);
  const Meshed first = results.wait_for(worker, "first");
  EXPECT_EQ(made, 2) << "surfaces that are alike have one mesh";
  scene.title = "second";
  scene.surfaces[1].z = "2*v";
  worker.request(scene, Manner::PreviewFirst);
  const Meshed second = results.wait_for(worker, "second");
  EXPECT_EQ(made, 3);
  EXPECT_EQ(second.surfaces[0], first.surfaces[0]);
  EXPECT_NE(second.surfaces[1], first.surfaces[1]);
  scene.title = "third";
  scene.surfaces[2].front.diffuse = {1, 0, 0};
  worker.request(scene, Manner::Full);
  EXPECT_EQ(results.wait_for(worker, "third").surfaces, second.surfaces);
  EXPECT_EQ(made, 3);
}

}  // namespace
}  // namespace saddle
