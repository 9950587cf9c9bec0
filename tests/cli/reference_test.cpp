// Comparisons with --reference: which changes of real pictures pass at the default threshold, which
// fail, and what a run leaves behind.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"

namespace saddle {
namespace {

using Names = std::vector<std::string>;

class Comparison : public ProgramTest {
 protected:
  Outcome draws(const std::string& picture, const std::string& to) {
    return with_words(picture, {"-q", "-s", "120x90", "-o", to});
  }
  Outcome compares(const std::string& picture, const std::string& reference) {
    return with_words(picture, {"-q", "-s", "120x90", "--reference", reference});
  }
  void leave_older_results() {
    EXPECT_EQ(draws("torus", "ref.png").status, 0);
    std::ofstream(path("ref.png.diff.png")) << "older";
    std::ofstream(path("report.json")) << "older";
  }

 private:
  Outcome with_words(const std::string& words, const std::vector<std::string>& more) {
    std::istringstream in(words);
    std::vector<std::string> arguments{std::istream_iterator<std::string>(in), {}};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return saddle(arguments);
  }
};

/// A picture and a change of it.
struct Change {
  const char* picture;
  const char* changed;
};

constexpr const char* kSphere = R"scene([camera]
target = [0, 0, 0]
distance = 6
[[surface]]
x = "cos(u)*cos(v)"
y = "sin(u)*cos(v)"
z = "sin(v)"
u = [0, "tau"]
v = ["-pi/2", "pi/2"]
grid = "off"
)scene";

// Beside the sphere, a hundredth of the picture.
constexpr const char* kSmallSphere = R"scene([[surface]]
x = "1.6+0.17*cos(u)*cos(v)"
y = "-1+0.17*sin(u)*cos(v)"
z = "0.17*sin(v)"
u = [0, "tau"]
v = ["-pi/2", "pi/2"]
grid = "off"
front = "COLOR"
)scene";

TEST_F(Comparison, PassesChangesThatAreHardToSee) {
  const Change changes[] = {
      {"torus", "torus"},
      // other passes of antialiasing
      {"torus", "torus --antialias 1"},
      {"torus", "torus --antialias 3"},
      {"torus --background white", "torus --background white --antialias 4"},
      {"boy", "boy --antialias 3"},
      {"torus --axes", "torus --axes --antialias 3"},
      // another driver, a finer mesh
      {"torus", "torus --renderer egl"},
      {"torus", "torus --tolerance 0.1px"},
      // rims and lines that move by a part of a pixel
      {"torus --target 0,0,0", "torus --target 0.015,0,0"},
      {"torus --grid off --target 0,0,0", "torus --grid off --target 0,0,0.015"},
      {"sphere --background white", "sphere --background white --view 2,-3,1.51"},
      {"sphere --grid 40x40", "sphere --grid 40x40 --view 2,-3,1.51"},
  };
  for (const auto& [picture, changed] : changes) {
    ASSERT_EQ(draws(picture, "ref.png").status, 0) << picture;
    const Outcome run = compares(changed, "ref.png");
    EXPECT_EQ(run.status, 0) << picture << " | " << changed << "\n" << run.err;
  }
}

TEST_F(Comparison, FailsChangesThatAreSeen) {
  const Change changes[] = {
      // colours: hue alone, dark ones, and one side
      {"torus --front yellow", "torus --front cyan"},
      {"torus --front #404000", "torus --front #004040"},
      {"torus --background white", "torus --background white --front cyan"},
      {"helicoid", "helicoid --back #ff8080"},
      {"torus", "torus --background #202020"},
      {"torus --background transparent", "torus"},
      {"torus", "torus --opacity 0.7"},
      // swapped sides
      {"torus", "torus --flip"},
      {"helicoid --background white", "helicoid --background white --flip"},
      // lines
      {"torus", "torus --grid off"},
      {"torus --background white", "torus --background white --grid off"},
      {"costa", "costa --grid off"},
      {"torus", "torus --grid 17x16"},
      {"torus", "torus --axes"},
      // form and place
      {"torus", "torus r=0.42"},
      {"torus", "torus --ortho"},
      {"torus", "torus --target 0.2,0,0"},
  };
  for (const auto& [picture, changed] : changes) {
    ASSERT_EQ(draws(picture, "ref.png").status, 0) << picture;
    const Outcome run = compares(changed, "ref.png");
    EXPECT_EQ(run.status, 1) << picture << " | " << changed << "\n" << run.err;
  }
}

TEST_F(Comparison, FailsWhereAnObjectOfAHundredthOfThePictureIsMissing) {
  for (const std::string color : {"#ffff80", "#303060", "white"}) {
    std::string both = std::string(kSphere) + kSmallSphere;
    both.replace(both.find("COLOR"), 5, color);
    std::ofstream(path("both.toml")) << both;
    std::ofstream(path("one.toml")) << kSphere;
    for (const std::string background : {"black", "white", "gray"}) {
      const std::string look = " --background " + background;
      ASSERT_EQ(draws("both.toml" + look, "ref.png").status, 0);
      EXPECT_EQ(compares("both.toml" + look, "ref.png").status, 0);
      EXPECT_EQ(compares("one.toml" + look, "ref.png").status, 1) << color << " on " << background;
    }
  }
}

TEST_F(Comparison, LeavesNoDifferenceWhereThePicturesAreEqual) {
  leave_older_results();
  EXPECT_EQ(compares("torus", "ref.png").status, 0);
  EXPECT_EQ(files(), (Names{"ref.png", "report.json"}));
}

TEST_F(Comparison, TellsWhatDiffersAndDrawsIt) {
  leave_older_results();
  const Outcome run = compares("sphere --report report.json", "ref.png");
  const std::string message = error_of(run, 1);
  EXPECT_TRUE(contains(message, "the threshold 0.05\n")) << message;
  EXPECT_TRUE(contains(message, "around pixel ")) << message;
  EXPECT_TRUE(contains(message, "ref.png.diff.png shows in red where\n")) << message;
  EXPECT_EQ(read_png(path("ref.png.diff.png")).image.width, 120);
  EXPECT_TRUE(read_file(path("report.json")).starts_with("{"));
  EXPECT_EQ(compares("sphere --threshold 1", "ref.png").status, 0);
  EXPECT_EQ(files(), (Names{"ref.png", "report.json"})) << "the difference was another run's";
}

TEST_F(Comparison, TellsTheSizesIfTheyDiffer) {
  EXPECT_EQ(draws("torus", "ref.png").status, 0);
  const std::string message = error_of(saddle({"torus", "-s", "9x7", "--reference", "ref.png"}), 1);
  EXPECT_TRUE(contains(message, "it has 9x7 pixels, not 120x90")) << message;
}

TEST_F(Comparison, LeavesNoOlderResultsWhereItFailsEarly) {
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"z=foo", "ref.png"},
      {"none.toml", "ref.png"},
      {"z=sqrt(-1)", "ref.png"},
      {"mobius --strict", "ref.png"},
      {"torus --threshold 2", "ref.png"},
      {"torus --grid q", "ref.png"},
      {"torus --nonsense", "ref.png"},
      {"torus --renderer q", "ref.png"},
      {"torus -o none/a.png", "ref.png"},
      {"torus --watch", "ref.png"},
      {"check torus", "ref.png"},
      {"torus", "none.png"},
      {"torus", "text.png"},
  };
  for (const auto& [words, reference] : broken) {
    leave_older_results();
    std::ofstream(path("text.png")) << "no picture";
    std::ofstream(path(reference + ".diff.png")) << "older";
    const Outcome run = compares(words + " --report report.json", reference);
    EXPECT_NE(run.status, 0) << words;
    EXPECT_FALSE(exists(reference + ".diff.png")) << words;
    EXPECT_TRUE(!exists("report.json") || read_file(path("report.json")) != "older") << words;
  }
}

TEST_F(Comparison, RefusesResultsInPlaceOfWhatItReads) {
  leave_older_results();
  std::ofstream(path("s.toml")) << kSphere;
  for (const std::string wrong : {"torus --report ref.png", "s.toml --report s.toml"}) {
    const Outcome run = compares(wrong, "ref.png");
    EXPECT_TRUE(contains(error_of(run, 2), "the run reads this file")) << run.err;
  }
  EXPECT_TRUE(contains(error_of(compares("torus -o ref.png.diff.png", "ref.png"), 2),
                       "two outputs are called"));
  EXPECT_EQ(read_file(path("s.toml")), kSphere);
  EXPECT_EQ(compares("torus", "ref.png").status, 0);
}

TEST_F(Comparison, ReadsTheReferenceBeforeItIsWrittenOver) {
  EXPECT_EQ(draws("torus", "ref.png").status, 0);
  EXPECT_EQ(compares("sphere -o ref.png", "ref.png").status, 1);
}

}  // namespace
}  // namespace saddle
