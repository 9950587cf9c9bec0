// The table of formats: its rows are whole, and what a format carries can be read back.
#include "export/formats/formats.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "base/error.h"
#include "export/formats/load_scene.h"
#include "scene/model/assignments.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Kind = Format::Kind;

Scene one_surface() {
  Scene scene;
  assign(scene, "z=u*v");
  scene.background = {0, 0, 1, 1};
  scene.picture.width = scene.picture.height = 16;
  return scene;
}

/// What the format's writer makes of the scene; nothing for an animation.
std::string written(const Format& format, const Scene& scene) {
  std::ostringstream out;
  const Image image(2, 2);
  const Mesh mesh;
  switch (format.kind) {
    case Kind::Picture:
      format.write_picture(out, {image, scene});
      break;
    case Kind::Mesh:
      format.write_mesh(out, {{&mesh, 1}, scene});
      break;
    case Kind::Page:
      format.write_page(out, {{&mesh, 1}, scene, scene, "all"});
      break;
    case Kind::Scene:
      format.write_scene(out, scene);
      break;
    case Kind::Animation:
      break;
  }
  return out.str();
}

TEST(Formats, HaveTheWriterOfTheirKindAndNoOther) {
  for (const Format& format : formats()) {
    EXPECT_EQ(format.write_picture != nullptr, format.kind == Kind::Picture) << format.extension;
    EXPECT_EQ(format.write_mesh != nullptr, format.kind == Kind::Mesh) << format.extension;
    EXPECT_EQ(format.write_page != nullptr, format.kind == Kind::Page) << format.extension;
    EXPECT_EQ(format.write_scene != nullptr, format.kind == Kind::Scene) << format.extension;
    EXPECT_EQ(format.video != nullptr, format.kind == Kind::Animation) << format.extension;
  }
}

TEST(Formats, HaveExtensionsOfTheirOwnInLowerCaseWithoutAPoint) {
  std::set<std::string_view> seen;
  for (const Format& format : formats()) {
    EXPECT_FALSE(format.extension.empty());
    EXPECT_TRUE(std::ranges::all_of(format.extension, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    })) << format.extension;
    EXPECT_TRUE(seen.insert(format.extension).second) << format.extension << " is there twice";
  }
}

TEST(Formats, AreFoundByTheirExtension) {
  for (const Format& format : formats()) {
    EXPECT_EQ(find_format(format.extension), &format) << format.extension;
  }
  EXPECT_EQ(find_format("PnG"), find_format("png"));
  EXPECT_EQ(find_format(""), nullptr);
  EXPECT_EQ(find_format(".png"), nullptr);
  EXPECT_EQ(find_format("pn"), nullptr);
  EXPECT_EQ(extension_of("a.b/c.d.PNG"), "PNG");
  EXPECT_EQ(extension_of("a.b/c"), "");
}

TEST(Formats, AreListedInTheOrderOfTheTable) {
  EXPECT_EQ(format_list(), "png, ply, stl, obj, glb, 3mf, html, svg, pdf, toml, gif, mp4 or webm");
  EXPECT_EQ(extension_list(),
            ".png .ply .stl .obj .glb .3mf .html .svg .pdf .toml .gif .mp4 .webm");
  EXPECT_EQ(extension_list(Kind::Animation), ".gif .mp4 .webm");
  EXPECT_EQ(extension_list(Kind::Mesh), ".ply .stl .obj .glb .3mf");
}

TEST(Formats, ThatAreDrawnAreThoseOfImages) {
  for (const Format& format : formats()) {
    EXPECT_EQ(format.is_drawn(), format.write_picture != nullptr || format.video != nullptr)
        << format.extension;
  }
}

TEST(Formats, BeginAsTheirSpecificationsSay) {
  const Scene scene = one_surface();
  EXPECT_TRUE(written(*find_format("png"), scene).starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_TRUE(written(*find_format("ply"), scene).starts_with("ply\nformat binary_little_endian"));
  EXPECT_TRUE(written(*find_format("html"), scene).starts_with("<!DOCTYPE html>\n"));
  EXPECT_TRUE(written(*find_format("svg"), scene).starts_with("<?xml version=\"1.0\""));
  EXPECT_TRUE(written(*find_format("pdf"), scene).starts_with("%PDF-1.4\n"));
  EXPECT_EQ(written(*find_format("toml"), scene), write_scene(scene));
}

TEST(Formats, ThatCarryASceneGiveItBack) {
  const Scene scene = one_surface();
  const std::string stem = testing::TempDir() + "saddle-formats-" + std::to_string(getpid());
  for (const Format& format : formats()) {
    const std::filesystem::path path = stem + "." + std::string(format.extension);
    EXPECT_EQ(has_scene_extension(path), format.carries_scene()) << path;
    if (!format.carries_scene()) continue;
    std::ofstream(path, std::ios::binary) << written(format, scene);
    EXPECT_EQ(write_scene(load_scene(path)), write_scene(scene)) << format.extension;
    std::filesystem::remove(path);
  }
}

TEST(Formats, OfScenesAreKnownByTheirFirstBytes) {
  for (const Format& format : formats()) {
    if (format.scene_in == nullptr) continue;
    EXPECT_EQ(format_of_bytes(written(format, one_surface())), &format) << format.extension;
  }
  EXPECT_EQ(format_of_bytes("title = 1"), nullptr);
}

TEST(LoadScene, ReadsAFileOfAnyOtherNameAsAScene) {
  const Scene scene = one_surface();
  const std::filesystem::path path =
      testing::TempDir() + "saddle-formats-" + std::to_string(getpid()) + ".txt";
  std::ofstream(path) << write_scene(scene);
  EXPECT_EQ(write_scene(load_scene(path)), write_scene(scene));
  std::filesystem::remove(path);
  try {
    load_scene(path);
    FAIL() << "it is gone";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Input);
    EXPECT_EQ(std::string(error.what()), "there is no file " + path.string());
  }
}

}  // namespace
}  // namespace saddle
