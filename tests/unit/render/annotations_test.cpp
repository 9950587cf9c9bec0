// Where ticks, labels and bars are, without a picture.
#include "render/overlay/annotations.h"
#include "render/overlay/label_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace saddle {
namespace {

const dvec2 kSize(400, 300);

Bounds box(const dvec3& low, const dvec3& high) {
  Bounds bounds;
  bounds.add(low);
  bounds.add(high);
  return bounds;
}

Scene scene_seen_from(const dvec3& view, bool ortho = false) {
  Scene scene;
  scene.axes = true;
  scene.camera.view = view;
  scene.camera.ortho = ortho;
  return scene;
}

FittedCamera fitted(const Scene& scene, const Bounds& bounds,
                    const std::vector<ColorScale>& scales = {}, const dvec2& size = kSize) {
  ViewPyramid seen = pyramid_beside_annotations(scene, scene.camera, bounds, scales, size);
  seen.add(bounds);
  return fit_camera(scene.camera, bounds, size.x / size.y, &seen);
}

dvec2 pixel_of(const FittedCamera& camera, const dvec3& p) {
  return saddle::pixel_of(camera, p, kSize).value();
}

struct Rect {
  dvec2 low, high;
};

Rect rect_of(const WrittenText& text) {
  static const Font font;
  const dvec2 half(font.width(text.text, text.size) / 2, font.height(text.size) / 2);
  return {text.middle - half, text.middle + half};
}

bool overlap(const Rect& a, const Rect& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

std::multiset<std::string> texts(const Annotations& all) {
  std::multiset<std::string> result;
  for (const WrittenText& text : all.texts) result.insert(text.text);
  return result;
}

const std::vector<dvec3>& views() {
  static const std::vector<dvec3> kViews = {
      {2, -3, 1.5}, {1, 1, 1},        {-3, 1, -2}, {0, 0, 1},   {0, 0, -1}, {1, 0, 0},
      {0, -1, 0},   {0.02, -1, 0.01}, {5, 5, 0.1}, {-1, -1, 4}, {1, -7, 0}, {0, 0.3, 1}};
  return kViews;
}

TEST(Axes, KeepLabelsApartAndInThePicture) {
  for (const dvec3& view : views()) {
    for (const bool ortho : {false, true}) {
      for (const Bounds& bounds : {box(dvec3(-1), dvec3(1)), box({0, 0, 0}, {10, 1, 0.1}),
                                   box({-1e-4, 1e7, -5}, {1e-4, 1e7 + 1, 4000})}) {
        const Scene scene = scene_seen_from(view, ortho);
        const FittedCamera camera = fitted(scene, bounds);
        const Annotations all = annotate(scene, camera, bounds, {}, kSize);
        for (std::size_t i = 0; i < all.texts.size(); ++i) {
          const Rect rect = rect_of(all.texts[i]);
          EXPECT_GE(std::min(rect.low.x, rect.low.y), 0);
          EXPECT_LE(rect.high.x, kSize.x);
          EXPECT_LE(rect.high.y, kSize.y);
          for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(overlap(rect, rect_of(all.texts[k])))
                << all.texts[i].text << " and " << all.texts[k].text;
          }
        }
      }
    }
  }
}

TEST(Axes, NeverHideWhatIsInTheBox) {
  const Bounds bounds = box({-1, -2, -0.5}, {1, 2, 0.5});
  for (const dvec3& view : views()) {
    const Scene scene = scene_seen_from(view);
    const FittedCamera camera = fitted(scene, bounds);
    const Annotations all = annotate(scene, camera, bounds, {}, kSize);
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        for (int k = 0; k < 3; ++k) {  // points of all six faces
          dvec3 share(i / 20.0, j / 20.0, 0);
          for (const double third : {0.0, 1.0}) {
            dvec3 p;
            p[k] = third;
            p[(k + 1) % 3] = share.x;
            p[(k + 2) % 3] = share.y;
            const dvec2 pixel = pixel_of(camera, bounds.low + p * bounds.size());
            for (const WrittenText& text : all.texts) {
              const Rect rect = rect_of(text);
              EXPECT_FALSE(pixel.x > rect.low.x && pixel.x < rect.high.x && pixel.y > rect.low.y &&
                           pixel.y < rect.high.y)
                  << text.text;
            }
          }
        }
      }
    }
  }
}

TEST(Axes, HaveTheirNamesInEveryViewThatShowsThem) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  const auto names = [&](const dvec3& view) {
    const Scene scene = scene_seen_from(view);
    const auto all = texts(annotate(scene, fitted(scene, bounds), bounds, {}, kSize));
    std::string found;
    for (const char* name : {"x", "y", "z"}) found += all.contains(name) ? name : "";
    return found;
  };
  EXPECT_EQ(names({2, -3, 1.5}), "xyz");
  EXPECT_EQ(names({-1, 2, -1}), "xyz");
  EXPECT_EQ(names({0, 0, 1}), "xy");
  EXPECT_EQ(names({1, 0, 0}), "yz");
  EXPECT_EQ(names({0, 1, 0}), "xz");
}

TEST(Axes, ShowNineEdgesOfABoxSeenFromACornerAndNoneInFront) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  const Scene scene = scene_seen_from({1, 1, 1});
  const Annotations all = annotate(scene, fitted(scene, bounds), bounds, {}, kSize);
  EXPECT_EQ(all.edges.size(), 9U);
  for (const auto& edge : all.edges) {
    EXPECT_FALSE(edge[0] == dvec3(1) || edge[1] == dvec3(1));  // the nearest corner
  }
}

TEST(Axes, PutTicksWhereTheirNumbersAre) {
  const Bounds bounds = box({0, 0, 0}, {4, 4, 4});
  Scene scene = scene_seen_from({0, 0, 1}, true);
  const FittedCamera camera = fitted(scene, bounds);
  const Annotations all = annotate(scene, camera, bounds, {}, kSize);
  const double x = pixel_of(camera, {3, 0, 0}).x;
  EXPECT_TRUE(std::ranges::any_of(all.texts, [&](const WrittenText& text) {
    return text.text == "3.0" && std::abs(text.middle.x - x) < 0.01 && text.middle.y > kSize.y / 2;
  }));
}

TEST(Axes, OfAFlatBoxHaveOneLabelAcrossIt) {
  const Bounds bounds = box({-1, -1, 7}, {1, 1, 7});
  const Scene scene = scene_seen_from({2, -3, 1.5});
  const auto all = texts(annotate(scene, fitted(scene, bounds), bounds, {}, kSize));
  EXPECT_EQ(all.count("7"), 1U);
}

TEST(Axes, HaveTheTitleIfTheSceneHasOne) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  Scene scene = scene_seen_from({1, 1, 1});
  EXPECT_FALSE(
      texts(annotate(scene, fitted(scene, bounds), bounds, {}, kSize)).contains(scene.title));
  scene.title = "Monkey saddle";
  EXPECT_TRUE(
      texts(annotate(scene, fitted(scene, bounds), bounds, {}, kSize)).contains("Monkey saddle"));
}

TEST(Axes, HaveATitleHoweverLongItIs) {
  Scene scene = scene_seen_from({2, -3, 1.5});
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  for (const auto& [title, begins] :
       {std::pair<std::string, std::string>{"a line\nand another", "a line and another"},
        {std::string(60, 'i'), std::string(60, 'i')},
        {"W" + std::string(2000, 'w'), "Wwwwwwwww"}}) {
    scene.title = title;
    const Annotations all = annotate(scene, fitted(scene, bounds), bounds, {}, kSize);
    const auto found = std::ranges::find_if(
        all.texts, [&](const WrittenText& text) { return text.text.starts_with(begins); });
    ASSERT_NE(found, all.texts.end()) << title;
    EXPECT_GE(rect_of(*found).low.x, 0);
    EXPECT_LE(rect_of(*found).high.x, kSize.x);
    EXPECT_EQ(found->text.ends_with("\u2026"), title.size() > 100);
  }
  EXPECT_EQ(annotate(scene, fitted(scene, bounds), bounds, {}, kSize).unknown, "");
  scene.title = "\u6f22 x \u5b57\u6f22";
  EXPECT_EQ(annotate(scene, fitted(scene, bounds), bounds, {}, kSize).unknown, "\u6f22\u5b57");
}

TEST(Axes, LookAtNoMoreOfATextThanAnyPictureHasRoomFor) {
  EXPECT_LE(one_line(std::string(1'000'000, 'a')).size(), 16384U);
  EXPECT_EQ(one_line("a\nb"), "a b");
}

TEST(Axes, HaveNoNumbersWithoutWhatTheseLeaveOut) {
  const Bounds bounds = box({1e7, 2e6, 3e9}, {1e7 + 1, 2e6 + 1, 3e9 + 1});
  for (const dvec2& size :
       {dvec2(400, 300), dvec2(160, 120), dvec2(100, 200), dvec2(64, 48), dvec2(40, 30)}) {
    for (const dvec3& view : views()) {
      const Scene scene = scene_seen_from(view);
      const Annotations all = annotate(scene, fitted(scene, bounds, {}, size), bounds, {}, size);
      const auto is_note = [](const WrittenText& text) { return text.text.ends_with(")"); };
      const auto is_name = [](const WrittenText& text) {
        return text.text.size() == 1 && text.text >= "x";
      };
      const auto notes = std::ranges::count_if(all.texts, is_note);
      EXPECT_EQ(std::ranges::count_if(all.texts, is_name), 0);
      EXPECT_TRUE(notes > 0 || all.texts.empty());
      EXPECT_TRUE(size.x < 400 || view != views()[0] || notes == 3) << notes;
    }
  }
}

TEST(Axes, FromInsideTheBoxHaveNoLabels) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  Scene scene = scene_seen_from({1, 1, 1});
  scene.camera.distance = 0.1;
  EXPECT_TRUE(annotate(scene, fitted(scene, bounds), bounds, {}, kSize).texts.empty());
}

TEST(Axes, LeaveAnExplicitCameraWhereItIs) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  Scene scene = scene_seen_from({1, 1, 1});
  scene.camera.distance = 5;
  EXPECT_EQ(fitted(scene, bounds).distance, 5);
}

TEST(ColorBars, HaveTheirNumbersBesideTheirColours) {
  Scene scene;
  const std::vector<ColorScale> scales = {{"gauss", "viridis", {-1, 1}}};
  const Annotations all =
      annotate(scene, fitted(scene, box(dvec3(-1), dvec3(1)), scales), {}, scales, kSize);
  ASSERT_EQ(all.bars.size(), 1U);
  EXPECT_EQ(texts(all).count("gauss"), 1U);
  const ColorBar& bar = all.bars[0];
  for (const WrittenText& text : all.texts) {
    if (text.text == "0.0") {
      EXPECT_NEAR(text.middle.y, bar.upper_left.y + bar.size.y / 2, 1);
    }
    if (text.text == "1.0") {
      EXPECT_NEAR(text.middle.y, bar.upper_left.y, 1);
    }
  }
}

TEST(ColorBars, StandSideBySideAndLeaveRoomForTheSurface) {
  Scene scene;
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  const std::vector<ColorScale> scales = {{"gauss", "viridis", {-1, 1}}, {"z", "magma", {0, 3e7}}};
  const FittedCamera camera = fitted(scene, bounds, scales);
  const Annotations all = annotate(scene, camera, bounds, scales, kSize);
  ASSERT_EQ(all.bars.size(), 2U);
  EXPECT_LT(all.bars[1].upper_left.x + all.bars[1].size.x, all.bars[0].upper_left.x);
  EXPECT_LT(pixel_of(camera, {1, 1, 0}).x, all.bars[1].upper_left.x);
}

TEST(ColorBars, ShortenLongFormulas) {
  Scene scene;
  std::string formula = "sin(u)";
  for (int i = 0; i < 30; ++i) formula += "+sin(u*v)";
  const std::vector<ColorScale> scales = {{formula, "viridis", {0, 1}}};
  const Annotations all =
      annotate(scene, fitted(scene, box(dvec3(-1), dvec3(1)), scales), {}, scales, kSize);
  EXPECT_TRUE(std::ranges::any_of(
      all.texts, [](const WrittenText& text) { return text.text.ends_with("\u2026"); }));
}

TEST(ColorBars, WriteAllThatTheirNumbersLeaveOut) {
  Scene scene;
  const std::string formula = "sin(u)*cos(v)+exp(-u^2-v^2)*(u^3-3*u*v^2)";
  const std::vector<ColorScale> scales = {{formula, "viridis", {1e7, 1e7 + 1}}};
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  for (const dvec2& size : {dvec2(400, 300), dvec2(160, 120), dvec2(100, 200)}) {
    const Annotations all =
        annotate(scene, fitted(scene, bounds, scales, size), bounds, scales, size);
    const auto has_note = [](const WrittenText& text) {
      return text.text.ends_with(" (+ 10000000)");
    };
    EXPECT_EQ(std::ranges::count_if(all.texts, has_note), 1) << size.x;
  }
}

TEST(Fonts, KnowTheWidthOfWhatTheyDraw) {
  const Font font;
  const TextBitmap bitmap = font.draw("\u22120.5", 20);
  EXPECT_NEAR(bitmap.width, font.width("\u22120.5", 20), 2);
  EXPECT_GT(std::ranges::count(bitmap.coverage, 255), 20);
  EXPECT_GT(font.width("WWW", 20), font.width("iii", 20));
  EXPECT_NEAR(font.width("100", 20), 2 * font.width("100", 10), 1e-4);
}

TEST(Fonts, MoveLettersTogetherWhereTheyFit) {
  const Font font;
  EXPECT_LT(font.width("AV", 100), font.width("A", 100) + font.width("V", 100) - 1);
}

TEST(Fonts, DrawWhatTheyDoNotKnowAsWell) {
  const Font font;
  EXPECT_GT(font.width("\xff", 20), 0);
  EXPECT_GT(font.width("\u4e2d", 20), 0);
}

std::vector<std::string> written(const Scene& scene) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  std::vector<std::string> result;
  for (const WrittenText& text : annotate(scene, fitted(scene, bounds), bounds, {}, kSize).texts) {
    result.push_back(text.text);
  }
  return result;
}

TEST(Titles, AreDrawnWithoutAxesIfTheSceneSaysSo) {
  Scene scene;
  scene.title = "A torus";
  EXPECT_TRUE(written(scene).empty());
  scene.show_title = true;
  EXPECT_EQ(written(scene), std::vector<std::string>{"A torus"});
  scene.title = Scene{}.title;
  EXPECT_EQ(written(scene), std::vector<std::string>{"saddle"}) << "asked for";
  scene.title.clear();
  EXPECT_TRUE(written(scene).empty()) << "there is nothing to write";
}

TEST(Titles, HaveRoomAboveWhatIsSeen) {
  Scene scene;
  scene.title = "A torus";
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  const auto highest = [&] {
    double y = kSize.y;
    const FittedCamera camera = fitted(scene, bounds);
    for (const dvec3& corner : bounds.corners()) y = std::min(y, pixel_of(camera, corner).y);
    return y;
  };
  EXPECT_NEAR(highest(), kPictureMargin * kSize.y, 0.5);
  scene.show_title = true;
  const WrittenText title = annotate(scene, fitted(scene, bounds), bounds, {}, kSize).texts.at(0);
  EXPECT_GT(highest(), rect_of(title).high.y);
}

TEST(Labels, AreTheScenesOwn) {
  Scene scene = scene_seen_from({2, -3, 1.5});
  scene.labels = {"time in s", "", "height"};
  const std::vector<std::string> all = written(scene);
  EXPECT_EQ(std::ranges::count(all, "time in s"), 1);
  EXPECT_EQ(std::ranges::count(all, "height"), 1);
  for (const char* usual : {"x", "y", "z"}) EXPECT_EQ(std::ranges::count(all, usual), 0) << usual;
}

TEST(Ticks, TellTrueNumbersInAStretchedPicture) {
  Scene scene = scene_seen_from({2, -3, 1.5});
  scene.scale = {.automatic = false, .factors = {1, 1, 0.01}};
  const Bounds bounds = box(dvec3(-1), dvec3(1));  // z is from -100 to 100
  const Annotations all = annotate(scene, fitted(scene, bounds), bounds, {}, kSize);
  const auto numbers = texts(all);
  EXPECT_EQ(numbers.count("100"), 1U);
  EXPECT_EQ(numbers.count("\u2212100"), 1U);
}

}  // namespace
}  // namespace saddle
