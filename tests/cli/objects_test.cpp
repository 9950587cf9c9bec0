// Several objects of a command line, names of parameters, and parts of surfaces.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "base/file.h"
#include "cli/program.h"
#include "ply_mesh.h"

namespace saddle {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  std::istringstream in(text);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

class Objects : public ProgramTest {
 protected:
  void make(const std::string& command) {
    const Outcome run = saddle(words_of(command));
    ASSERT_EQ(run.status, 0) << command << "\n" << run.err;
  }
  std::string content(const std::string& name) const { return read_file(path(name)); }
  /// The boxes of the surfaces that a command graphs.
  std::vector<std::array<double, 6>> boxes_of(const std::string& command) {
    make(command + " -o box.ply --report r.json");
    const auto report = nlohmann::json::parse(content("r.json"));
    std::vector<std::array<double, 6>> boxes;
    for (const auto& surface : report["surfaces"]) {
      const auto& b = surface["bounds"];
      boxes.push_back({b[0][0], b[0][1], b[0][2], b[1][0], b[1][1], b[1][2]});
    }
    return boxes;
  }
  /// The names in the report of a command: of surfaces, curves, then points.
  Words names_in(const std::string& command) {
    make(command + " -o a.toml -s 64x48 -o a.png --report r.json");
    Words names;
    const auto report = nlohmann::json::parse(content("r.json"));
    for (const char* kind : {"surfaces", "curves", "points"}) {
      if (!report.contains(kind)) continue;
      for (const auto& object : report[kind]) names.push_back(object["name"]);
    }
    return names;
  }
};

TEST_F(Objects, AreEachWhatTheirSegmentSays) {
  const auto boxes = boxes_of("torus r=0.4 + torus r=0.6 R=3 + z=a*u^2 a=2");
  ASSERT_EQ(boxes.size(), 3U);
  EXPECT_NEAR(boxes[0][3], 2.4, 1e-6);
  EXPECT_NEAR(boxes[0][5], 0.4, 1e-2);
  EXPECT_NEAR(boxes[1][3], 3.6, 1e-6);
  EXPECT_NEAR(boxes[1][5], 0.6, 1e-2);
  EXPECT_NEAR(boxes[2][5], 2, 1e-6);
}

TEST_F(Objects, ShareTheDefinitionsOfFormulas) {
  const auto boxes = boxes_of("z=a*u + torus + z=a*v^2+f(1) a=3 f(s)=a+s");
  EXPECT_NEAR(boxes[0][5], 3, 1e-6);
  EXPECT_NEAR(boxes[1][3], 2.8, 1e-6);  // the torus has an R and r of its own
  EXPECT_NEAR(boxes[2][5], 7, 1e-6);
}

TEST_F(Objects, KeepTheNamesOfTheGalleryApart) {
  // r is the torus's own, shared by the two formulas, and the sphere's own.
  const auto boxes = boxes_of("torus r=0.1 + z=r*u r=5 + sphere + z=r*v");
  EXPECT_NEAR(boxes[0][5], 0.1, 1e-2);
  EXPECT_NEAR(boxes[1][5], 5, 1e-6);
  EXPECT_NEAR(boxes[2][5], 1, 1e-2);
  EXPECT_NEAR(boxes[3][5], 5, 1e-6);
  // A shared definition that hides a constant hides it in no gallery surface.
  const auto hidden = boxes_of("dini + z=pi*u pi=5");
  EXPECT_EQ(hidden[0], boxes_of("dini")[0]);
  EXPECT_NEAR(hidden[1][5], 5, 1e-6);
}

TEST_F(Objects, TakeWhatStandsBeforeAllOfThem) {
  const auto boxes = boxes_of("r=0.25 a=2 + torus + torus r=0.5 + z=a*u+r");
  EXPECT_NEAR(boxes[0][3], 2.25, 1e-6);
  EXPECT_NEAR(boxes[1][3], 2.5, 1e-6);
  EXPECT_NEAR(boxes[2][5], 2.25, 1e-6);
  make("--front red --grid off + torus + z=u --front blue -o a.toml");
  const std::string scene = content("a.toml");
  EXPECT_TRUE(contains(scene, "front = { diffuse = \"#ff0000\" }"));
  EXPECT_TRUE(contains(scene, "front = { diffuse = \"#0000ff\" }"));
}

TEST_F(Objects, HaveOptionsOfTheirOwn) {
  make(
      "torus --shading exact --name ring + sphere --samples 8x4 --specular blinn --name ball -s "
      "30x20 "
      "-o a.toml -o a.png --report r.json");
  const auto report = nlohmann::json::parse(content("r.json"));
  EXPECT_EQ(report["surfaces"][0]["name"], "ring");
  EXPECT_EQ(report["surfaces"][1]["name"], "ball");
  EXPECT_GT(report["surfaces"][0]["cells"], 100);
  EXPECT_EQ(report["surfaces"][1]["cells"], 32);
  const std::string scene = content("a.toml");
  const std::size_t second = scene.rfind("[[surface]]");
  EXPECT_LT(scene.find("shading = \"exact\""), second);
  EXPECT_GT(scene.find("samples = \"8x4\""), second);
  EXPECT_GT(scene.find("specular = \"blinn\""), second);
  EXPECT_TRUE(contains(scene, "size = \"30x20\""));
  make("torus --name ring + sphere --samples 8x4 --name ball -o a.ply");
  const std::string ply = content("a.ply");
  EXPECT_TRUE(contains(ply, "comment object ring, faces 0 to ")) << ply.substr(0, 300);
  EXPECT_TRUE(contains(ply, "comment object ball, faces ")) << ply.substr(0, 300);
}

TEST_F(Objects, AreToldApartByANumberBehindTheirName) {
  EXPECT_EQ(names_in("torus + torus + torus"), (Words{"torus", "torus 2", "torus 3"}));
  EXPECT_EQ(names_in("--name ring + torus + sphere + curve x=s + curve x=2*s"),
            (Words{"ring", "ring 2", "ring 3", "ring 4"}));
  EXPECT_EQ(names_in("torus + curve x=s + curve x=2*s"), (Words{"torus", "curve", "curve 2"}));
  std::ofstream(path("on.toml")) << "[[surface]]\nname = 'torus'\nz = '5'\n"
                                    "[[point]]\nu = 0\nv = 0\non = 'torus'\n";
  EXPECT_EQ(names_in("torus + on.toml"), (Words{"torus", "torus 2", "point"}));
  EXPECT_TRUE(contains(content("a.toml"), "on = \"torus 2\""));
  std::ofstream(path("same.toml")) << "[[surface]]\nz = 1\n[[surface]]\nz = 2\n";
  EXPECT_EQ(names_in("same.toml"), (Words{"surface", "surface 2"}));
}

TEST_F(Objects, TakeCameraAndLightsOfTheFirstSceneFile) {
  std::ofstream(path("a.toml"))
      << "background = \"red\"\n[params]\nd = 7\n[[surface]]\nz = \"d*u\"\n"
         "[camera]\ndistance = \"2*d\"\n";
  std::ofstream(path("b.toml"))
      << "background = \"blue\"\n[params]\nd = 3\n[[surface]]\nz = \"d*u\"\n";
  const auto boxes = boxes_of("sphere + a.toml + b.toml + z=d*u d=1");
  EXPECT_NEAR(boxes[1][5], 7, 1e-6);
  EXPECT_NEAR(boxes[2][5], 3, 1e-6);
  EXPECT_NEAR(boxes[3][5], 1, 1e-6);
  make("sphere + a.toml + b.toml + z=d*u d=1 -o c.toml");
  EXPECT_TRUE(contains(content("c.toml"), "background = \"#ff0000\""));
  EXPECT_TRUE(contains(content("c.toml"), "distance = \"2*d\""));
}

/// Any scene of several objects, from its parts.
std::string random_command(std::mt19937& random) {
  const auto one_of = [&](const Words& words) {
    return words[std::uniform_int_distribution<std::size_t>(0, words.size() - 1)(random)];
  };
  const Words objects = {"torus",
                         "torus r=0.3 R=1.5",
                         "sphere r=0.7",
                         "superellipsoid e=0.6",
                         "trefoil-tube r=0.3",
                         "z=a*x^2-y x=-1:1 y=0:1",
                         "z=cos(theta)*f(p) x=p*sin(theta) theta=0:pi p=0:2",
                         "z=f(u)*v where=u^2+v^2<k",
                         "x=-2:2 y=cos(φ) z=sin(φ) φ=0:tau"};
  const Words options = {"",
                         "--front tomato",
                         "--opacity 0.5",
                         "--color z --colormap magma",
                         "--grid 5x7",
                         "--flip",
                         "--shading exact",
                         "--shading vertex --specular blinn",
                         "--samples 12x9",
                         "--name part"};
  std::string command = "a=0.5 k=0.75 f(s)=s^2+a --back gold";
  const int count = std::uniform_int_distribution<int>(2, 4)(random);
  for (int i = 0; i < count; ++i) {
    command += " + " + one_of(objects) + " " + one_of(options) + " " + one_of(options);
  }
  return command;
}

TEST_F(Objects, SurviveASceneFileToTheByteOfThePicture) {
  std::mt19937 random(7);
  for (int run = 0; run < 12; ++run) {
    const std::string command = random_command(random);
    SCOPED_TRACE(command);
    make(command + " -s 48x36 --antialias 1 -q -o a.png -o a.toml");
    make("a.toml -q -o b.png -o b.toml");
    EXPECT_EQ(content("a.png"), content("b.png"));
    EXPECT_EQ(content("a.toml"), content("b.toml"));
  }
}

TEST_F(Objects, NameTheirParametersInSentences) {
  make("z=x^2-y^2 x=-3:3 y=-2:2 -o a.toml");
  EXPECT_TRUE(contains(content("a.toml"), "parameters = [\"x\", \"y\"]\nz = \"x^2-y^2\"\n"));
  EXPECT_TRUE(contains(content("a.toml"), "y = [\"-2\", \"2\"]"));
  const Outcome check = saddle(words_of("check x=s*cos(φ) y=s*sin(φ) z=s φ=0:tau s=0:1"));
  EXPECT_TRUE(contains(check.out, "domain      phi = 0:6.28319, s = 0:1")) << check.out;
  EXPECT_TRUE(contains(check.out, "phi = 0 and phi = 6.28319 join")) << check.out;
  EXPECT_TRUE(contains(check.out, "s = 0 is the point (0, 0, 0)")) << check.out;
  EXPECT_FALSE(contains(check.out, "u = ")) << check.out;
  EXPECT_FALSE(contains(check.out, "v = ")) << check.out;
}

TEST_F(Objects, GiveTheSameSurfaceUnderAnyName) {
  make("x=sin(u)*cos(v) y=sin(u)*sin(v) z=cos(u)+diff(u^2,u) u=0:pi v=0:tau -o a.ply");
  make(
      "x=sin(theta)*cos(phi) y=sin(theta)*sin(phi) z=cos(theta)+diff(theta^2,theta) theta=0:pi "
      "φ=0:tau -o b.ply");
  EXPECT_TRUE(mesh_in_ply(content("a.ply")) == mesh_in_ply(content("b.ply")));
  // u first, wherever it stands; x and y likewise; a coordinate that is a parameter is itself.
  make("z=u-v^2 -o a.ply");
  make("z=x-y^2 y=-1:1 x=-1:1 -o b.ply");
  EXPECT_TRUE(mesh_in_ply(content("a.ply")) == mesh_in_ply(content("b.ply")));
  make("x=v y=cos(u) z=sin(u) u=0:tau -o a.ply");
  make("u=0:tau x=-1:1 y=cos(u) z=sin(u) -o b.ply");
  EXPECT_TRUE(mesh_in_ply(content("a.ply")) == mesh_in_ply(content("b.ply")));
}

/// Vertices and triangles of a PLY of saddle's.
struct Ply {
  std::vector<std::array<float, 3>> position;
  std::vector<std::array<std::int32_t, 3>> triangles;

  explicit Ply(const std::string& bytes) {
    const auto number_after = [&](const std::string& word) {
      return std::stoul(bytes.substr(bytes.find(word) + word.size()));
    };
    position.resize(number_after("element vertex "));
    triangles.resize(number_after("element face "));
    const char* at = bytes.data() + bytes.find("end_header\n") + 11;
    constexpr std::size_t kVertex = 6 * sizeof(float) + 2 * sizeof(double);
    for (auto& p : position) {
      std::memcpy(p.data(), at, sizeof p);
      at += kVertex;
    }
    for (auto& t : triangles) {
      std::memcpy(t.data(), at + 1, sizeof t);
      at += 1 + sizeof t;
    }
  }

  /// The sides that only one triangle has.
  std::vector<std::array<std::int32_t, 2>> edge() const {
    std::map<std::array<std::int32_t, 2>, int> count;
    for (const auto& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        ++count[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
      }
    }
    std::vector<std::array<std::int32_t, 2>> sides;
    for (const auto& [side, triangles_of_it] : count) {
      if (triangles_of_it == 1) sides.push_back(side);
    }
    return sides;
  }
};

TEST_F(Objects, EndOnTheEdgeOfTheirRegion) {
  make("z=x^2+y^2 where=x^2+y^2<1 --tolerance 1e-3 -o a.ply --strict");
  const Ply mesh(content("a.ply"));
  const auto edge = mesh.edge();
  ASSERT_GT(edge.size(), 20U);
  const double tolerance = 1e-3 * std::sqrt(4 + 4 + 1.0);
  for (const auto& [a, b] : edge) {
    const auto& p = mesh.position[static_cast<std::size_t>(a)];
    const auto& q = mesh.position[static_cast<std::size_t>(b)];
    EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 1e-6);  // of floats
    EXPECT_NEAR(std::hypot((p[0] + q[0]) / 2, (p[1] + q[1]) / 2), 1, tolerance);
  }
}

TEST_F(Objects, TellARegionAsOne) {
  const Outcome check =
      saddle(words_of("check z=x^2+y^2 where=x^2+y^2<1 --strict --report r.json"));
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_TRUE(contains(check.out, "region      x^2+y^2<1: 78.5")) << check.out;
  EXPECT_TRUE(contains(check.out, "singular    none")) << check.out;
  EXPECT_TRUE(contains(check.out, "(a disc), one edge")) << check.out;
  const auto surface = nlohmann::json::parse(content("r.json"))["surfaces"][0];
  EXPECT_NEAR(surface["outside_fraction"], 1 - std::acos(-1) / 4, 1e-3);
  EXPECT_EQ(surface["undefined_fraction"], 0);
  const double area = std::acos(-1) / 6 * (std::pow(5, 1.5) - 1);
  EXPECT_NEAR(surface["area"], area, 1e-3 * area);
  const Outcome none = saddle(words_of("z=u where=u>2 -o a.ply"));
  EXPECT_EQ(none.status, 3);
  EXPECT_TRUE(contains(none.err, "where: no part of the surface is where this holds")) << none.err;
}

}  // namespace
}  // namespace saddle
