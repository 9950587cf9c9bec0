#include "export/threemf.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "export/zip.h"
#include "exported.h"

namespace saddle {
namespace {

constexpr std::size_t kAll = std::size_t{1} << 30;

std::string model_of(const Mesh& mesh, const Scene& scene = kSurfaceScene) {
  return part_of_zip(bytes_of(write_3mf, {{&mesh, 1}, scene}), "3D/3dmodel.model", kAll, "a.3mf")
      .value();
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ThreeMf, HasItsThreePartsAndTheSameBytesOnAnyNumberOfThreads) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  MeshContent content{{&mesh, 1}, scene};
  content.threads = 1;
  const std::string file = bytes_of(write_3mf, content);
  for (const char* part : {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"}) {
    EXPECT_TRUE(part_of_zip(file, part, kAll, "a.3mf")) << part;
  }
  content.threads = 4;
  EXPECT_EQ(bytes_of(write_3mf, content), file);
}

TEST(ThreeMf, IsAModelOfPointsIfClosed) {
  const std::string model = model_of(tetrahedron());
  EXPECT_NE(model.find("unit=\"millimeter\""), std::string::npos);
  EXPECT_NE(model.find("type=\"model\""), std::string::npos);
  EXPECT_EQ(count_of(model, "<vertex "), 4U);
  EXPECT_NE(model.find("<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>"), std::string::npos);
}

TEST(ThreeMf, IsASurfaceIfOpen) {
  const std::string model = model_of(open_square());
  EXPECT_NE(model.find("type=\"surface\""), std::string::npos);
  EXPECT_EQ(model.find("type=\"model\""), std::string::npos);
}

TEST(ThreeMf, PaintsTheBackThatIsOutsideForTheSecondExtruder) {
  const std::string model = model_of(tetrahedron({}, true));
  EXPECT_EQ(count_of(model, "p1=\"1\" slic3rpe:mmu_segmentation=\"8\""), 4U);
  EXPECT_NE(model.find("<triangle v1=\"0\" v2=\"2\" v3=\"1\""), std::string::npos) << "outward";
  EXPECT_EQ(count_of(model_of(tetrahedron()), "mmu_segmentation=\"8\""), 0U);
}

TEST(ThreeMf, PaintsTheBackAndTheWallsOfASolid) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].front.diffuse = {1, 0, 0};
  scene.surfaces[0].back.diffuse = {0, 0, 1};
  const std::string model = model_of(thick_square(), scene);
  EXPECT_NE(model.find("type=\"model\""), std::string::npos);
  EXPECT_EQ(count_of(model, "<triangle "), 12U);
  EXPECT_EQ(count_of(model, "p1=\"1\" slic3rpe:mmu_segmentation=\"8\""), 2U);
  EXPECT_EQ(count_of(model, "mmu_segmentation=\"8\""), 2U);
  EXPECT_EQ(count_of(model, "p1=\"3\"/>"), 8U);
  EXPECT_EQ(count_of(model, "<m:color color=\"#800080FF\"/>"), 1U) << "walls: the mean";
}

TEST(ThreeMf, HasColoursOfNumbersOnAllOfASolid) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].color = "u";
  const std::string model = model_of(thick_square(true), scene);
  EXPECT_EQ(count_of(model, " p2=\""), 12U);
}

TEST(ThreeMf, HasColoursOfNumbersAtCorners) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].color = "u";
  const std::string model = model_of(numbered_square(), scene);
  EXPECT_EQ(count_of(model, "<m:color "), 4 + 256U);
  EXPECT_NE(model.find("<triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"1\" p1=\"4\" p2=\"259\" "
                       "p3=\"259\"/>"),
            std::string::npos);
}

TEST(ThreeMf, EscapesWhatXmlReserves) {
  Scene scene = scene_of_surface();
  scene.title = "a<b & \"c\"";
  scene.surfaces[0].name = "x<y";
  const Mesh mesh = tetrahedron();
  const std::string model = model_of(mesh, scene);
  EXPECT_NE(model.find("<metadata name=\"Title\">a&lt;b &amp; &quot;c&quot;<"), std::string::npos);
  EXPECT_NE(model.find("name=\"x&lt;y\""), std::string::npos);
  const auto text = scene_in_3mf(bytes_of(write_3mf, {{&mesh, 1}, scene}), "a.3mf");
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("title = \"a<b & \\\"c\\\"\""), std::string::npos) << *text;
}

TEST(Zip, KeepsPartsOfManyBlocksOnAnyNumberOfThreads) {
  std::string text;
  for (std::size_t key = 0; text.size() < (std::size_t{18} << 20); ++key) {
    text += std::to_string(static_cast<int>(1000 * random_unit(key))) + "\n";
  }
  const auto zipped = [&](unsigned threads) {
    std::ostringstream out;
    ZipWriter zip(out, threads);
    zip.add("empty", [](std::ostream&) {});
    zip.add("text", [&](std::ostream& part) { part << text; });
    zip.finish();
    return out.str();
  };
  const std::string file = zipped(1);
  EXPECT_EQ(zipped(3), file);
  EXPECT_LT(file.size(), text.size() / 2);
  EXPECT_EQ(part_of_zip(file, "text", kAll, "a"), text);
  EXPECT_EQ(part_of_zip(file, "empty", kAll, "a"), "");
  EXPECT_EQ(part_of_zip(file, "text", 100, "a"), text.substr(0, 100));
  EXPECT_EQ(part_of_zip(file, "other", kAll, "a"), std::nullopt);
}

TEST(Zip, RefusesDamagedFilesWithoutReadingBeyondThem) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  const std::string file = bytes_of(write_3mf, {{&mesh, 1}, scene});
  EXPECT_THROW(part_of_zip("", "x", kAll, "a"), Error);
  EXPECT_THROW(part_of_zip(file.substr(0, file.size() / 2), "x", kAll, "a"), Error);
  std::uint64_t key = 0;
  const auto below = [&](std::size_t count) {
    return static_cast<std::size_t>(static_cast<double>(count) * random_unit(++key));
  };
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = file;
    for (int k = 0; k < 8; ++k) damaged[below(damaged.size())] = static_cast<char>(below(256));
    for (int k = 0; k < 2; ++k) damaged[damaged.size() - 1 - below(300)] = '\xff';
    try {
      scene_in_3mf(damaged, "a.3mf");
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::Input);
    }
  }
}

}  // namespace
}  // namespace saddle
