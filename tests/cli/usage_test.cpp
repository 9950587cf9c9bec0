// What the program says about itself and about wrong command lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/file.h"
#include "cli/program.h"
#include "paths.h"
#include "scene/options/options.h"

namespace saddle {
namespace {

class Usage : public ProgramTest {
 protected:
  /// The message of a wrong command line, which leaves no file behind.
  std::string refusal(const std::vector<std::string>& arguments) {
    const std::string message = error_of(saddle(arguments), 2);
    EXPECT_TRUE(files().empty()) << files().front();
    return message;
  }
  std::string content(const std::string& name) const { return read_file(path(name)); }
};

TEST_F(Usage, HelpHasALineOrTwoForEveryOption) {
  const Outcome run = saddle({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  std::istringstream lines(run.out);
  std::string line;
  for (; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  for (const Option& option : options()) {
    if (!option.is_option()) continue;
    EXPECT_TRUE(contains(run.out, " " + dashed(option))) << option.name;
    if (option.letter != 0) {
      EXPECT_TRUE(contains(run.out, std::string("  -") + option.letter + ", " + dashed(option)))
          << option.name;
    }
  }
  EXPECT_FALSE(contains(run.out, "{")) << "a name in braces is left";
  EXPECT_EQ(saddle({"-h"}).out, run.out);
  EXPECT_EQ(saddle({"torus", "--help"}).out, run.out);
}

TEST_F(Usage, HelpExplainsOneOption) {
  for (const Option& option : options()) {
    if (!option.is_option()) continue;
    const Outcome run = saddle({"--help", std::string(option.name)});
    EXPECT_EQ(run.status, 0) << option.name;
    EXPECT_TRUE(contains(run.out, dashed(option))) << run.out;
  }
  const Outcome shading = saddle({"--help", "shading"});
  EXPECT_TRUE(contains(shading.out, "Values: vertex pixel exact unlit\n")) << shading.out;
  EXPECT_TRUE(contains(shading.out, "Default: pixel\n")) << shading.out;
  EXPECT_TRUE(contains(shading.out, "Scene files: shading")) << shading.out;
  EXPECT_TRUE(contains(refusal({"--help", "shadnig"}), "did you mean 'shading'?"));
  for (const std::vector<std::string>& form : std::vector<std::vector<std::string>>{
           {"--help", "--shading"}, {"--help=shading"}, {"-h", "shading"}}) {
    EXPECT_EQ(saddle(form).out, shading.out) << form[0];
  }
  EXPECT_EQ(saddle({"--help", "-s"}).out, saddle({"--help", "size"}).out);
  EXPECT_EQ(saddle({"--help", "check"}).out, saddle({"--help"}).out);
  const std::string key = saddle({"--help", "show_title"}).out;
  EXPECT_TRUE(key.starts_with("show_title = BOOLEAN\n")) << key;
  EXPECT_TRUE(contains(key, "Scene files: show_title, at the top of the file\n")) << key;
}

TEST_F(Usage, HelpListsTheKeysOfSceneFiles) {
  const Outcome run = saddle({"--help", "scene"});
  EXPECT_EQ(run.status, 0);
  for (const Option& option : options()) {
    if (option.table == Table::None) continue;
    const bool is_listed = option.stroke || option.curve || option.point;  // without a default
    const std::string key = std::string(option.name);
    EXPECT_TRUE(contains(run.out, is_listed ? key : "  " + key + " = ")) << option.name;
  }
  EXPECT_LE(std::ranges::count(run.out, '\n'), 62) << "one screen";
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_TRUE(contains(saddle({"--help", "status"}).out, "3  there is nothing to draw"));
}

TEST_F(Usage, TakesOptionsInEveryForm) {
  for (const std::vector<std::string>& form : std::vector<std::vector<std::string>>{
           {"-s", "8x6"}, {"-s8x6"}, {"--size", "8x6"}, {"--size=8x6"}, {"-qs8x6"}}) {
    std::vector<std::string> arguments = {"torus", "-o", "a.toml"};
    arguments.insert(arguments.end(), form.begin(), form.end());
    EXPECT_EQ(saddle(arguments).status, 0) << form[0];
    EXPECT_TRUE(contains(content("a.toml"), "size = \"8x6\"")) << form[0];
  }
  EXPECT_EQ(saddle({"z=u", "--view", "-1,2,3", "-o", "a.toml"}).status, 0);
  EXPECT_TRUE(contains(content("a.toml"), "view = [-1, 2, 3]"));
  EXPECT_EQ(saddle({"z=u", "-s", "9x9", "-s", "7x7", "-o", "a.toml"}).status, 0);
  EXPECT_TRUE(contains(content("a.toml"), "size = \"7x7\"")) << "the last counts";
  EXPECT_EQ(saddle({"z=u", "--flip", "-s", "q", "--flip", "-s", "7x7", "-o", "a.toml"}).status, 0);
  EXPECT_TRUE(contains(content("a.toml"), "flip = true")) << "once";
  EXPECT_EQ(saddle({"z=u", "--colormap", "magma", "--color", "z", "-o", "a.toml"}).status, 0);
  EXPECT_TRUE(contains(content("a.toml"), "colormap = \"magma\""));
  EXPECT_TRUE(contains(error_of(saddle({"z=u", "--colormap", "magma", "-o", "b.toml"}), 2),
                       "nothing to colour"));
}

TEST_F(Usage, HelpListsTheFormulaLanguage) {
  const Outcome run = saddle({"--help", "functions"});
  EXPECT_EQ(run.status, 0);
  for (const char* name : {"sin", "besselj0", "diff", "tau"}) {
    EXPECT_TRUE(contains(run.out, name)) << name;
  }
}

TEST_F(Usage, HelpListsTheKeysOfTheViewer) {
  const Outcome run = saddle({"--help", "keys"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.out, "Ctrl-Q")) << run.out;
}

TEST_F(Usage, RefusesWhatWouldBeIgnored) {
  EXPECT_TRUE(contains(refusal({"z=u", "z=v", "-o", "a.png"}), "'z' is given twice"));
  EXPECT_TRUE(
      contains(refusal({"f(s)=s", "f(s,q)=s", "z=u", "-o", "a.png"}), "'f' is given twice"));
  EXPECT_TRUE(contains(refusal({"z=u", "-o", "a.png", "--report", "./a.png"}), "two outputs"));
  EXPECT_TRUE(contains(refusal({"z=u", "-o", "a.png", "--front", "#ff000080"}), "see-through"));
  EXPECT_TRUE(contains(refusal({"show", "torus", "r=foo"}), "unknown name 'foo'"));
}

TEST_F(Usage, PrintsItsVersion) {
  const Outcome run = saddle({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("saddle ")) << run.out;
  EXPECT_EQ(std::ranges::count(run.out, '.'), 2) << run.out;
  EXPECT_EQ(saddle({"-V"}).out, run.out);
}

TEST_F(Usage, TakesSizesAndOffInTheFormsThatPeopleType) {
  const auto scene = [&](const std::string& option, const std::string& value) {
    EXPECT_EQ(saddle({"z=u", option, value, "-o", "a.toml"}).status, 0) << option << " " << value;
    return content("a.toml");
  };
  EXPECT_TRUE(contains(scene("-s", "192,108"), "size = \"192x108\""));
  EXPECT_EQ(scene("--grid", "8"), scene("--grid", "8x8"));
  EXPECT_EQ(scene("--grid", "8,9"), scene("--grid", "8x9"));
  EXPECT_EQ(scene("--grid", "none"), scene("--grid", "off"));
  EXPECT_EQ(scene("--samples", "7"), scene("--samples", "7x7"));
  EXPECT_EQ(scene("--clip", "none"), scene("--clip", "off"));
  EXPECT_EQ(scene("--background", "none"), scene("--background", "transparent"));
}

TEST_F(Usage, TakesNamesInGreek) {
  const auto scene = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", "a.toml"});
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return content("a.toml");
  };
  const std::string own = scene({"z=θ*u+Δx1", "θ=2", "Δx1=γ", "γ=3"});
  EXPECT_TRUE(contains(own, "\n\"θ\" = 2\n\"Δx1\" = \"γ\"\n\"γ\" = 3\n")) << own;
  std::ofstream(path("b.toml")) << own;
  EXPECT_EQ(scene({"b.toml"}), own) << "keys of TOML in quotes";
  EXPECT_TRUE(contains(scene({"b.toml", "θ=5"}), "\"θ\" = 5\n"));
  // φ, τ and π are the constants' other names, also where they are defined anew.
  EXPECT_EQ(scene({"z=phi*u", "φ=2"}), scene({"z=phi*u", "phi=2"}));
  EXPECT_EQ(saddle({"z=f(u)+2π+τ", "f(φ)=φ^2", "-o", "a.toml"}).status, 0);
}

TEST_F(Usage, ExplainsSlipsInGreek) {
  EXPECT_TRUE(contains(refusal({"z=u", "φ=2", "phi=3", "-o", "c.toml"}), "'phi' is given twice"));
  EXPECT_TRUE(contains(refusal({"z=γ(u)", "-o", "c.toml"}), "unknown name 'γ'"));
  EXPECT_TRUE(contains(refusal({"z=πu", "-o", "c.toml"}), "write π*u"));
}

TEST_F(Usage, EndsQuietlyWhereTheReaderHasGone) {
  const std::string program = program_path();
  for (const std::string wanted :
       {"list", "--help", "show torus", "check torus", "torus -o - --format ply"}) {
    const std::string command = "{ " + program + " " + wanted + " 2>" + path("err").string() +
                                "; echo $? >" + path("status").string() + "; } | true";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(content("err"), "") << wanted;
    EXPECT_EQ(content("status"), "0\n") << wanted;
  }
}

TEST_F(Usage, ListsTheGalleryALineEach) {
  const Outcome run = saddle({"list"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.out, "\ntrefoil-tube\n"));
  EXPECT_TRUE(contains(saddle({"list", "--verbose"}).out, "\ntrefoil-tube  "));
  EXPECT_GE(std::ranges::count(run.out, '\n'), 24);
  EXPECT_TRUE(contains(refusal({"list", "torus"}), "takes no arguments"));
  EXPECT_TRUE(contains(refusal({"list", "--quiet"}), "--quiet"));
}

TEST_F(Usage, ShowsAGallerySurfaceAsASceneFile) {
  const Outcome run = saddle({"show", "torus", "r=0.4"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("title = \"torus\"\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "\nr = 0.4\n")) << run.out;
  EXPECT_TRUE(contains(refusal({"show"}), "needs the name"));
  EXPECT_TRUE(contains(refusal({"show", "tours"}), "did you mean 'torus'?"));
}

TEST_F(Usage, TakesVerbsOnlyAsTheFirstArgument) {
  EXPECT_TRUE(contains(refusal({"--quiet", "list"}), "no surface is called 'list'"));
}

TEST_F(Usage, WantsASurfaceAndAnOutput) {
  EXPECT_TRUE(contains(refusal({}), "no surface given"));
  const std::string no_window = error_of(saddle({"torus"}), 1);  // tests have no display
  EXPECT_TRUE(contains(no_window, "no window can be opened")) << no_window;
  EXPECT_TRUE(contains(no_window, "-o FILE.png"));
  EXPECT_TRUE(contains(refusal({"torus", "sphere", "-o", "a.png"}), "two scenes"));
}

TEST_F(Usage, WatchesOnlySceneFilesInTheViewer) {
  EXPECT_TRUE(contains(refusal({"torus", "--watch"}), "no scene file to watch"));
  EXPECT_TRUE(contains(refusal({"torus", "--watch", "-o", "a.png"}), "only the viewer"));
  EXPECT_TRUE(contains(refusal({"torus", "--renderer", "egl"}), "OpenGL of its display"));
}

TEST_F(Usage, NamesTheNearestOption) {
  EXPECT_TRUE(contains(refusal({"torus", "--smaples", "3x3", "-o", "a.png"}), "'--samples'?"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "--lacquer", "0.1"}), "unknown option"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "-x"}), "unknown option '-x'"));
}

TEST_F(Usage, RefusesTolerancesThatAreNone) {
  for (const char* value : {"0", "-1", "px", "0px", "1pt", "nan", "1e-3%"}) {
    const std::string text = refusal({"torus", "-o", "a.png", "--tolerance", value});
    EXPECT_TRUE(contains(text, "--tolerance")) << text;
  }
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "--normal-tolerance", "181"}), "180"));
  refusal({"torus", "-o", "a.png", "--max-triangles", "0"});
}

TEST_F(Usage, NamesTheNearestSurfaceParameterColourAndExtension) {
  EXPECT_TRUE(contains(refusal({"helicod", "-o", "a.png"}), "did you mean 'helicoid'?"));
  EXPECT_TRUE(contains(refusal({"torus", "q=1", "-o", "a.png"}), "known names: R r x y z u v t"));
  EXPECT_TRUE(contains(refusal({"torus", "--front", "yelow", "-o", "a.png"}), "'yellow'?"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.pgn"}), "did you mean '.png'?"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.avi"}), "known: .png .ply"));
}

TEST_F(Usage, PutsTheCaretUnderThePlace) {
  EXPECT_TRUE(refusal({"z=u", "y=cos(u)*foo(v)", "-o", "a.png"})
                  .starts_with("saddle: y: unknown name 'foo'\n"
                               "  y = cos(u)*foo(v)\n"
                               "             ^~~\n"));
  EXPECT_TRUE(refusal({"z=u", "v=0:2*bar", "-o", "a.png"})
                  .starts_with("saddle: v: unknown name 'bar'\n"
                               "  v = 0:2*bar\n"
                               "          ^~~\n"));
  EXPECT_TRUE(refusal({"torus", "--size", "80x0", "-o", "a.png"})
                  .starts_with("saddle: --size: must be from 1 to 16384\n"
                               "  --size 80x0\n"
                               "            ^\n"));
  EXPECT_TRUE(refusal({"torus", "--view", "1,2+foo,3", "-o", "a.png"})
                  .starts_with("saddle: --view: unknown name 'foo'\n"
                               "  --view 1,2+foo,3\n"
                               "             ^~~\n"));
}

TEST_F(Usage, RefusesValuesOutOfRange) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--size", "800"},
      {"--size", "16385x1"},
      {"--size", "axb"},
      {"--size", "1x99999999999999"},
      {"--size", ""},
      {"--samples", "0x5"},
      {"--samples", "9999999x9999999"},
      {"--grid", "1x4"},
      {"--grid", "of"},
      {"--antialias", "0"},
      {"--antialias", "17"},
      {"--antialias", "2.5"},
      {"--renderer", "metal"},
      {"--threads", "0"},
      {"--view", "0,0,0"},
      {"--view", "1,2"},
      {"--view", "1,2,3,4"},
      {"--view", "1,2,1/0"},
      {"--up", "0,0,0"},
      {"--distance", "0"},
      {"--fov", "180"},
      {"--fov", "0"},
      {"--background", "#12"},
      {"--t", "u"},
      {"--t", "1/0"},
      {"--report", ""},
      {"--format", "gif"},
      {"--format", "png"},
  };
  for (const auto& option : wrong) {
    const std::string message = refusal({"torus", "-o", "a.png", option[0], option[1]});
    EXPECT_TRUE(contains(message, option[0])) << message;
  }
}

TEST_F(Usage, SaysWhichOptionLacksItsValue) {
  EXPECT_TRUE(contains(refusal({"torus", "--size"}), "--size: the value is missing"));
  EXPECT_TRUE(contains(refusal({"torus", "-o"}), "--output: the value is missing"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "--axes"}), "--output: the value is missing"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "--axes=on"}), "takes no value"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "--fov="}), "--fov: the value is empty"));
  EXPECT_TRUE(contains(refusal({"-s", "z=u", "-o", "a.png"}), "--size z=u"));
  EXPECT_TRUE(contains(refusal({"z=u", "-size", "8x6", "-o", "a.png"}), "did you mean '--size'?"));
  EXPECT_TRUE(contains(refusal({"nofile.toml", "--grid", "q"}), "--grid"));
}

TEST_F(Usage, RefusesOptionsThatWouldDoNothing) {
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "--threshold", "0.1"}), "--reference"));
  EXPECT_TRUE(contains(refusal({"torus", "-o", "a.png", "-q", "-v"}), "--verbose"));
  EXPECT_TRUE(contains(refusal({"list", "--format", "png"}), "list takes no option --format"));
  EXPECT_TRUE(contains(refusal({"torus", "--format", "png"}), "no output needs a format"));
}

}  // namespace
}  // namespace saddle
