// Meshes in all formats: names, files beside, warnings, and opening them again.
#include <gtest/gtest.h>

#include <fstream>

#include "base/file.h"
#include "cli/program.h"
#include "exported.h"

namespace saddle {
namespace {

using Names = std::vector<std::string>;

class Export : public ProgramTest {
 protected:
  void done(const std::vector<std::string>& arguments, const std::string& err = "") {
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, err);
  }
};

const Names kMeshFormats = {"ply", "stl", "obj", "glb", "3mf"};

TEST_F(Export, WritesEachFormatAndTheFilesBesideIt) {
  done({"torus", "-o", "a.ply", "-o", "a.stl", "-o", "a.obj", "-o", "a.glb", "-o", "a.3mf"});
  EXPECT_EQ(files(), (Names{"a.3mf", "a.glb", "a.mtl", "a.obj", "a.ply", "a.stl"}));
  done({"torus", "--color", "z", "-o", "b.obj"});
  EXPECT_TRUE(exists("b-color.png"));
}

TEST_F(Export, OpensWhatItWrote) {
  done({"torus", "r=0.4", "--color", "z", "-o", "scene.toml"});
  const std::string scene = read_file(path("scene.toml"));
  for (const std::string& format : kMeshFormats) {
    if (format == "stl") continue;
    const std::string name = "a." + format;
    done({"torus", "r=0.4", "--color", "z", "-o", name});
    done({name, "-o", "again.toml"});
    EXPECT_EQ(read_file(path("again.toml")), scene) << format;
    done({name, "-o", "b." + format});
    EXPECT_EQ(read_file(path("b." + format)).size(), read_file(path(name)).size()) << format;
  }
  EXPECT_TRUE(contains(error_of(saddle({"a.stl", "-o", "b.png"}), 2),
                       ".stl has no room for one; these have: .png .ply .obj .glb .3mf"));
}

TEST_F(Export, SaysThatAForeignFileHoldsNoScene) {
  std::ofstream(path("foreign.obj")) << "v 0 0 0\n";
  EXPECT_TRUE(contains(error_of(saddle({"foreign.obj", "-o", "a.png"}), 2), "holds no scene"));
  std::ofstream(path("foreign.glb")) << "not one";
  EXPECT_TRUE(contains(error_of(saddle({"foreign.glb", "-o", "a.png"}), 2), "is not a GLB file"));
  std::ofstream(path("foreign.3mf")) << "not one";
  EXPECT_TRUE(contains(error_of(saddle({"foreign.3mf", "-o", "a.png"}), 2), "is not a 3MF file"));
}

TEST_F(Export, WritesTheSameToStandardOutput) {
  for (const std::string& format : kMeshFormats) {
    done({"torus", "-o", "a." + format});
    const Outcome run = saddle({"torus", "-o", "-", "--format", format});
    EXPECT_EQ(run.status, 0) << run.err;
    if (format == "obj") {
      EXPECT_FALSE(contains(run.out, "mtllib"));
    } else {
      EXPECT_TRUE(run.out == read_file(path("a." + format))) << format;
    }
  }
}

TEST_F(Export, IsTheSameOnAnyNumberOfThreads) {
  for (const std::string& format : kMeshFormats) {
    done({"torus", "--tolerance", "1e-4", "--threads", "1", "-o", "a." + format});
    done({"torus", "--tolerance", "1e-4", "--threads", "3", "-o", "b." + format});
    std::string b = read_file(path("b." + format));
    if (format == "obj") b.replace(b.find("b.mtl"), 1, "a");
    EXPECT_TRUE(b == read_file(path("a." + format))) << format;
  }
}

TEST_F(Export, WritesAMeshForEachFrame) {
  for (const std::string& format : kMeshFormats) {
    const Outcome run =
        saddle({"sphere", "z=cos(v)*(1+t)", "t=0:1", "--frames", "2", "-o", "f-%02d." + format});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(exists("f-00." + format) && exists("f-01." + format)) << format;
    EXPECT_NE(read_file(path("f-00." + format)), read_file(path("f-01." + format))) << format;
  }
  EXPECT_TRUE(exists("f-00.mtl") && exists("f-01.mtl"));
  EXPECT_TRUE(contains(read_file(path("f-01.obj")), "mtllib f-01.mtl"));
}

TEST_F(Export, WarnsOfWhatIsNoSolidOncePerFile) {
  const Outcome run = saddle({"z=u*v", "t=0:1", "--frames", "3", "-o", "f-%d.stl", "-o", "a.obj"});
  EXPECT_EQ(run.status, 0);
  const std::size_t first = run.err.find("f-%d.stl: no solid that can be printed: ");
  EXPECT_NE(first, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("f-%d.stl", first + 1), std::string::npos) << run.err;
  EXPECT_FALSE(contains(run.err, "a.obj"));
}

TEST_F(Export, FailsStrictlyBeforeAnythingIsWritten) {
  const Outcome run = saddle({"z=u*v", "--strict", "-o", "a.stl", "-o", "a.obj", "-o", "a.png"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.err, "open edges")) << run.err;
  EXPECT_EQ(files(), Names{});
  done({"torus", "--strict", "-o", "a.stl"});
}

TEST_F(Export, RefusesOutputsThatMeet) {
  for (const Names& both : {Names{"a.obj", "a-color.png"}, Names{"a-color.png", "a.obj"}}) {
    const Outcome run = saddle({"torus", "-o", both[0], "-o", both[1]});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err, "a.obj also writes a-color.png")) << run.err;
  }
  EXPECT_EQ(saddle({"torus", "-o", "a.obj", "--report", "a.mtl"}).status, 2);
  EXPECT_EQ(files(), Names{});
}

TEST_F(Export, LeavesNothingIfAFileBesideCannotBeWritten) {
  std::filesystem::create_directory(path("a.mtl"));
  EXPECT_EQ(saddle({"torus", "-o", "a.obj"}).status, 1);
  EXPECT_EQ(files(), Names{"a.mtl"});
}

TEST_F(Export, PrintsInMillimetresAndTurnsUp) {
  done({"torus", "--print-size", "80", "-o", "a.stl"});
  const auto corners = [&](const std::string& name) {
    const std::string stl = read_file(path(name));
    std::vector<dvec3> result;
    for (std::size_t at = 84; at < stl.size(); at += 50) {
      for (std::size_t k = 12; k < 48; k += 12) {
        result.emplace_back(number_in<float>(stl, at + k), number_in<float>(stl, at + k + 4),
                            number_in<float>(stl, at + k + 8));
      }
    }
    Bounds bounds;
    for (const dvec3& p : result) bounds.add(p);
    return bounds.size();
  };
  EXPECT_NEAR(corners("a.stl").x, 80, 1e-4);
  EXPECT_NEAR(corners("a.stl").z, 80 * 1.6 / 5.6, 0.05);
  done({"torus", "--print-size", "80", "--mesh-up", "y", "-o", "b.stl"});
  EXPECT_NEAR(corners("b.stl").y, corners("a.stl").z, 1e-4);
  EXPECT_TRUE(contains(saddle({"torus", "--print-size", "0", "-o", "a.stl"}).err, "--print-size"));
}

TEST_F(Export, KeepsTheUnitsWhateverThePictureIsStretchedTo) {
  done({"torus", "-o", "a.stl"});
  done({"torus", "--scale", "1,1,5", "-o", "b.stl"});
  EXPECT_EQ(read_file(path("a.stl")), read_file(path("b.stl")));
}

TEST_F(Export, HoldsLinesWhereThereIsRoom) {
  done({"curve", "x=cos(s)", "y=sin(s)", "s=0:tau", "+", "point", "1,2,3", "-o", "a.obj", "-o",
        "a.glb"});
  const std::string obj = read_file(path("a.obj"));
  EXPECT_TRUE(contains(obj, "\nl ")) << obj;
  EXPECT_TRUE(contains(obj, "\np ")) << obj;
  const Outcome stl = saddle({"curve", "x=s", "-o", "b.stl"});
  EXPECT_EQ(stl.status, 3);
  EXPECT_TRUE(contains(stl.err, "--radius")) << stl.err;
  EXPECT_FALSE(exists("b.stl"));
}

}  // namespace
}  // namespace saddle
