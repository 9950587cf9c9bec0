// The start page: the gallery in pictures, which the window does not wait for.
#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "render/gl/gl.h"
#include "scene/model/gallery.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

/// The threads that make OpenGL programs while it lives. One at a time.
class ProgramMakers {
 public:
  ProgramMakers() {
    makers_.clear();
    create_ = glad_glCreateProgram;
    glad_glCreateProgram = [] {
      const std::lock_guard lock(mutex_);
      makers_.insert(std::this_thread::get_id());
      return create_();
    };
  }
  ~ProgramMakers() { glad_glCreateProgram = create_; }
  ProgramMakers(const ProgramMakers&) = delete;
  ProgramMakers& operator=(const ProgramMakers&) = delete;

  static std::set<std::thread::id> makers() {
    const std::lock_guard lock(mutex_);
    return makers_;
  }

 private:
  static inline std::mutex mutex_;
  static inline std::set<std::thread::id> makers_;
  static inline PFNGLCREATEPROGRAMPROC create_ = nullptr;
};

TEST_F(Workplace, DrawsThePicturesOfTheGalleryBesideTheWindow) {
  ViewerSetup setup = setup_of({});
  setup.start = true;
  Viewer viewer(std::move(setup));
  const ProgramMakers threads;
  ASSERT_TRUE(until(viewer, [&] { return yellow_pixels(screenshot()) > 10'000; }));
  const auto makers = ProgramMakers::makers();
  EXPECT_EQ(makers.size(), 1U);
  EXPECT_FALSE(makers.contains(std::this_thread::get_id())) << "the window's thread draws none";
}

TEST_F(Workplace, BeginsWithThePicturesOfTheGallery) {
  ViewerSetup setup = setup_of({});
  setup.start = true;
  Viewer viewer(std::move(setup));
  viewer.step();
  EXPECT_FALSE(viewer.is_at_rest()) << "keys do not wait for the pictures";
  key(viewer, "", kDown);
  key(viewer, "Return", kReturn);
  ASSERT_TRUE(until(viewer, [&] { return !viewer.model().scene().surfaces.empty(); }));
  EXPECT_TRUE(rests(viewer));
  const std::string chosen = viewer.model().scene().title;
  EXPECT_NE(chosen, gallery()[0].name) << "an arrow has gone to the next row";
  EXPECT_NE(find_gallery_entry(chosen), nullptr);
}

}  // namespace
}  // namespace saddle
