// What saddle says to command lines that are wrong: a row for each message, as a person would
// provoke it, and what they would type next. A message names the mistake; its hint works.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "cli/program.h"

namespace saddle {
namespace {

class Messages : public ProgramTest {
 protected:
  /// The words of a command line; a formula with spaces stands in single quotes.
  static std::vector<std::string> words(const std::string& command) {
    std::vector<std::string> result;
    std::string word;
    bool quoted = false;
    for (const char c : command + " ") {
      if (c == '\'') {
        quoted = !quoted;
      } else if (c == ' ' && !quoted) {
        if (!word.empty()) result.push_back(word);
        word.clear();
      } else {
        word += c;
      }
    }
    return result;
  }
  Outcome run(const std::string& command) { return saddle(words(command)); }
};

/// A wrong command, how its message begins and a part of the hint, and a right one.
struct Row {
  const char* command;
  const char* message;
  const char* hint;
  const char* instead;  ///< what the hint says, done; empty: nothing to try
};

constexpr Row kRows[] = {
    // names of surfaces
    {"klein -o a.toml", "no surface is called 'klein'", "'klein-figure8' or 'klein-bottle'?",
     "klein-bottle -o a.toml"},
    {"mobius-strip -o a.toml", "no surface is called 'mobius-strip'", "did you mean 'mobius'?",
     "mobius -o a.toml"},
    {"helicod -o a.toml", "no surface is called 'helicod'", "did you mean 'helicoid'",
     "helicoid -o a.toml"},
    {"qqq -o a.toml", "no surface is called 'qqq'", "known surfaces: sphere ", "list"},
    {"none.toml -o a.toml", "there is no file none.toml", "saddle list", "list"},
    {"torus sphere -o a.toml", "two scenes, 'torus' and 'sphere'", "one at a time",
     "sphere -o a.toml"},
    {"z=u + v -o a.toml", "two scenes, '+' and 'v'", "in quotes: z='u + v'", "'z=u + v' -o a.toml"},
    {"z=u +v -o a.toml", "no surface is called '+v'", "in quotes if it has spaces: z='u + v'",
     "'z=u + v' -o a.toml"},
    {"", "no surface given", "saddle --help says more", "--help"},
    {"--quiet list", "no surface is called 'list'", "", "list"},
    {"list torus", "saddle list takes no arguments, not 'torus'", "saddle show NAME", "show torus"},
    {"show", "saddle show needs the name of a surface", "saddle show torus", "show torus"},
    // assignments
    {"torus k=3 -o a.toml", "argument: torus has no 'k'", "known names: R r x y z u v t",
     "torus r=0.3 -o a.toml"},
    {"torus r=0.3,0.9 -o a.toml", "r: two results in one formula", "a decimal point is '.'",
     "torus r=0.39 -o a.toml"},
    {"torus r=0,9 -o a.toml", "r: a decimal comma", "write 0.9", "torus r=0.9 -o a.toml"},
    {"torus r= -o a.toml", "r: the expression is empty", "for example r=", "torus r=1 -o a.toml"},
    {"torus =3 -o a.toml", "argument: the name is missing", "NAME=EXPRESSION", ""},
    {"z=u 2a=3 -o a.toml", "argument: '2a' is not a name", "does not begin with a digit",
     "z=a2*u a2=3 -o a.toml"},
    {"z=u f()=3 -o a.toml", "argument: a helper function without arguments",
     "leave the brackets out", "z=f*u f=3 -o a.toml"},
    {"z=u x(s)=3 -o a.toml", "argument: 'x' cannot be a helper function", "another name", ""},
    {"z=u z=v -o a.toml", "argument: 'z' is given twice", "leave one of them out", "z=v -o a.toml"},
    {"z=u sin=3 -o a.toml", "sin: 'sin' is a function of the language", "choose another name", ""},
    {"z=a*u a=b b=a -o a.toml", "a: a definition that needs itself: a -> b -> a",
     "break the circle", ""},
    {"x=u -o a.toml", "z has no formula", "z='sin(u)*cos(v)'", "x=u 'z=sin(u)*cos(v)' -o a.toml"},
    // ranges
    {"z=x^2-y^2 x=-3:3 -o a.toml", "x: only u, v and t have a range", "write u=-3:3; x is u",
     "z=x^2-y^2 u=-3:3 -o a.toml"},
    {"z=x^2-y^2 y=-3:3 -o a.toml", "y: only u, v and t have a range", "write v=-3:3; y is v",
     "z=x^2-y^2 v=-3:3 -o a.toml"},
    {"z=theta theta=0:pi -o a.toml", "theta: only u, v and t have a range",
     "for example u=0:pi theta=u", "z=theta u=0:pi theta=u -o a.toml"},
    {"z=u u=3 -o a.toml", "u: a range is MIN:MAX", "u=0:2*pi", "z=u u=0:2*pi -o a.toml"},
    {"z=u u=0:1:2 -o a.toml", "u: a range has one ':'", "u=0:2*pi", ""},
    {"z=u u=:1 -o a.toml", "u: the lower end is missing", "u=0:2*pi", ""},
    {"z=u u=1: -o a.toml", "u: the upper end is missing", "u=0:2*pi", ""},
    {"z=u u=1:1 -o a.ply", "u: the range of u is empty", "its ends must differ",
     "z=u u=0:1 -o a.ply"},
    {"z=u u=0:v -o a.ply", "u: the range of u cannot depend on v", "the ends of v may depend on u",
     "z=u v=0:u -o a.ply"},
    {"z=u v=u:u -o a.ply", "v: the range of v is empty", "its ends must differ", ""},
    {"z=u u=0:1/0 -o a.ply", "u: this end of the range is not a finite number", "", ""},
    // formulas
    {"z=foo(u) -o a.ply", "z: unknown name 'foo'", "did you mean 'floor'?", "z=floor(u) -o a.ply"},
    {"'z=sin u' -o a.ply", "z: 'sin' needs its argument in brackets", "write sin(u)",
     "'z=sin(u)' -o a.ply"},
    {"'z=u v' -o a.ply", "z: an operator is missing", "write u*v", "z=u*v -o a.ply"},
    {"z=arctan(u) -o a.ply", "z: unknown name 'arctan'", "did you mean 'atan'?",
     "z=atan(u) -o a.ply"},
    {"z=(u -o a.ply", "z: this bracket is not closed", "add a ')'", "z=(u) -o a.ply"},
    {"z=u) -o a.ply", "z: this bracket was never opened", "remove it", "z=u -o a.ply"},
    {"z=u,v -o a.ply", "z: two results in one formula", "z takes one formula", ""},
    {"z=u&v -o a.ply", "z: a single '&'", "'and' is &&", "z=u&&v -o a.ply"},
    {"z=5! -o a.ply", "z: '!' is not part of the language", "n! is gamma(n+1)",
     "z=gamma(5+1)+u -o a.ply"},
    {"z=u%2 -o a.ply", "z: '%' is not part of the language", "mod(a,b)", "z=mod(u,2) -o a.ply"},
    {"z=πu -o a.ply", "z: an operator is missing", "write π*u", "z=π*u -o a.ply"},
    {"z=mod(u) -o a.ply", "z: 'mod' takes 2 arguments, not 1", "", ""},
    // options
    {"torus -o=x.png", "-o takes its value without a '='", "write -o x.png or --output=x.png",
     "torus -o x.toml"},
    {"torus --smaples 3x3 -o a.toml", "unknown option '--smaples'", "did you mean '--samples'?",
     "torus --samples 3x3 -o a.toml"},
    {"torus -x -o a.toml", "unknown option '-x'", "saddle --help lists the options", "--help"},
    {"torus --size", "--size: the value is missing", "write --size WxH", "--help size"},
    {"torus --fov= -o a.toml", "--fov: the value is empty", "write --fov DEG", "--help fov"},
    {"torus --axes=on -o a.toml", "--axes: takes no value", "write --axes alone",
     "torus --axes -o a.toml"},
    {"torus --threshold 0.1 -o a.toml", "--threshold: does nothing without --reference",
     "add --reference FILE", "--help reference"},
    {"torus -q -v -o a.toml", "--verbose: says the opposite of --quiet", "leave one of them out",
     "torus -q -o a.toml"},
    {"list --quiet", "saddle list takes no option --quiet", "saddle list --verbose",
     "list --verbose"},
    {"--help foo", "there is no help on 'foo'", "other topics are functions, scene, status",
     "--help status"},
    {"--help shadnig", "there is no help on 'shadnig'", "did you mean 'shading'?",
     "--help shading"},
    // values of options
    {"torus -s 800 -o a.toml", "--size: this is two whole numbers with an x between", "80x60",
     "torus -s 80x60 -o a.toml"},
    {"torus -s 80x0 -o a.toml", "--size: must be from 1 to 16384", "", ""},
    {"torus --grid of -o a.toml", "--grid: not a whole number", "write digits alone",
     "torus --grid off -o a.toml"},
    {"torus --grid 1x4 -o a.toml", "--grid: the first and the last line are the ends", "at least 2",
     "torus --grid 0x4 -o a.toml"},
    {"torus --samples 99999x99999 -o a.toml", "--samples: more than", "", ""},
    {"torus --view 1,2 -o a.toml", "--view: a vector has three numbers, this one has 2",
     "--view 2,-3,1.5", "torus --view 2,-3,1.5 -o a.toml"},
    {"torus --view 0,0,0 -o a.toml", "--view: a direction needs a length", "must not be 0", ""},
    {"torus --fov 180 -o a.toml", "--fov: must be more than 0 and less than 180", "", ""},
    {"torus --antialias 2.5 -o a.toml", "--antialias: not a whole number", "digits alone", ""},
    {"torus --scale 1,2 -o a.toml", "--scale: a scale has a factor for each axis",
     "for example --scale 1,1,0.1", "torus --scale 1,1,0.1 -o a.toml"},
    {"torus --scale 1,2,0 -o a.toml", "--scale: a factor must be more than 0", "", ""},
    {"z=u --scale 1,1,k k=-2 -o a.toml", "scale: must be more than 0", "it is -2", ""},
    {"torus --scale eqal -o a.toml", "--scale: unknown value 'eqal'", "did you mean 'equal'?",
     "torus --scale equal -o a.toml"},
    {"torus --theme papper -o a.toml", "--theme: unknown value 'papper'", "did you mean 'paper'?",
     "torus --theme paper -o a.toml"},
    {"torus --labels a,b -o a.toml", "--labels: three texts are wanted",
     "for example --labels x,y,height", "torus --labels x,y,height -o a.toml"},
    {"torus --line-width 0 -o a.toml", "--line-width: must be more than 0 and less than 100", "",
     "torus --line-width 0.5 -o a.toml"},
    {"torus --line-color '#12345678' -o a.toml", "--line-color: a colour of a surface has no alpha",
     "#rrggbb, or a name", "torus --line-color '#123456' -o a.toml"},
    {"torus --title= -o a.toml", "--title: the value is empty", "write --title TEXT",
     "torus --title Torus -o a.toml"},
    {"torus --background blak -o a.toml", "--background: unknown colour 'blak'",
     "did you mean 'black'?", "torus --background black -o a.toml"},
    {"torus --background #12 -o a.toml", "--background: a colour has 3, 6 or 8 hex", "#ffff80",
     "torus --background #ffff80 -o a.toml"},
    {"torus --background #12345g -o a.toml", "--background: not a hexadecimal digit", "#rrggbb",
     ""},
    {"torus --front #ff000080 -o a.toml", "--front: a colour of a surface has no alpha",
     "--opacity", "torus --front #ff0000 --opacity 0.5 -o a.toml"},
    {"torus --colormap magma -o a.toml", "--colormap: there is nothing to colour", "--color z",
     "torus --colormap magma --color z -o a.toml"},
    {"torus --color z --colormap viridi -o a.toml", "--colormap: no colormap is called 'viridi'",
     "'viridis'", "torus --color z --colormap viridis -o a.toml"},
    {"torus --shading phong -o a.toml", "--shading: unknown value 'phong'",
     "one of: vertex pixel exact", "torus --shading exact -o a.toml"},
    {"torus --tolerance 0 -o a.toml", "--tolerance: must be more than 0", "--tolerance 0.5px",
     "torus --tolerance 0.5px -o a.toml"},
    {"torus --clip 0:1 -o a.toml", "--clip: a box has three ranges", "--clip -1:1,-1:1,0:5",
     "torus --clip -1:1,-1:1,0:5 -o a.toml"},
    {"torus --clip 1:0,0:1,0:1 -o a.toml", "--clip: this range is empty", "-1:1,-1:1,0:5", ""},
    {"torus --t u -o a.toml", "--t: this must be a constant", "numbers, constants", ""},
    // outputs
    {"torus -o a.pgn", "--output: unknown extension '.pgn'", "did you mean '.png'?",
     "torus -s 9x9 -o a.png"},
    {"torus -o a", "--output: no extension says what to write", "known: .png",
     "torus -o a --format toml"},
    {"torus -o -", "--output: the format for standard output is missing", "add --format png",
     "torus -s 9x9 -o - --format png"},
    {"torus --format gif -o a.toml", "--format: no output needs a format", "-o -", ""},
    {"torus --format gfi -o -", "--format: unknown format 'gfi'", "did you mean '.gif'?", ""},
    {"torus -o a.toml --report a.toml", "two outputs of different kinds are called a.toml",
     "its own name", "torus -o a.toml --report b.json"},
    {"torus -o - --format ply --report -", "only one thing can go to standard output",
     "give the others a file", ""},
    {"torus --watch -o a.png", "--watch: only the viewer watches a file", "leave out --output", ""},
    {"torus --watch", "--watch: there is no scene file to watch", "-o FILE.toml", ""},
    {"torus --frames 3 -o a.png", "--frames: no output has frames", "-o frame-%04d.png",
     "z=u*t --frames 1 -s 9x9 -o frame-%04d.png"},
    {"z=u*t t=3 -o a.gif", "argument: no output shows this moment", "leave the moment out", ""},
    {"z=u*t --frames 2 --frame-range 1:2 -o a.gif", "--frame-range: there is no frame 2",
     "frames 0 to 1", ""},
    {"z=u*t -o a%d%d.png", "--output: two places for the frame's number", "frame-%04d.png", ""},
    {"z=u*t -o a%d.gif", "--output: a video is one file for all frames", "leave out the number",
     ""},
    {"chart torus -o a.pdf", "--output: a chart is no '.pdf'", "", ""},
    {"chart torus", "nothing says where the chart goes", "-o chart.svg", ""},
    // scene files
    {"key.toml -o a.toml", "key.toml:1:1: unknown key 'grif'", "known keys:", ""},
    {"type.toml -o a.toml", "type.toml:1:7: title: must be", "", ""},
    {"toml.toml -o a.toml", "toml.toml:1:", "saddle show torus", "show torus"},
    {"empty.toml -o a.toml", "empty.toml:1:1: the scene has no [[surface]]", "saddle show torus",
     "show torus"},
    {"node.toml -o a.toml", "node.toml:3:7: surface 1: in: no node is called 'wheel'",
     "the scene has no [[node]]", ""},
    {"plain.png -o a.toml", "plain.png is not a PNG file", "", ""},
};

TEST_F(Messages, NameTheMistakeAndAWayOutThatWorks) {
  std::ofstream(path("key.toml")) << "grif = 3\n";
  std::ofstream(path("type.toml")) << "title=3\n[[surface]]\nz = \"u\"\n";
  std::ofstream(path("toml.toml")) << "title = torus\n";
  std::ofstream(path("empty.toml")) << "title = \"nothing\"\n";
  std::ofstream(path("node.toml")) << "[[surface]]\nz = \"u\"\nin = \"wheel\"\n";
  std::ofstream(path("plain.png")) << "no picture";
  for (const Row& row : kRows) {
    const std::string text = error_of(run(row.command), 2);
    EXPECT_TRUE(text.starts_with(std::string("saddle: ") + row.message)) << row.command << "\n"
                                                                         << text;
    EXPECT_TRUE(contains(text, row.hint)) << row.command << "\n" << text;
    EXPECT_TRUE(std::string_view(row.hint).empty() || text.find('\n') + 1 < text.size()) << text;
    if (std::string_view(row.instead).empty()) continue;
    const Outcome instead = run(row.instead);
    EXPECT_EQ(instead.status, 0) << row.command << " | " << row.instead << "\n" << instead.err;
  }
}

/// Warnings of command lines that are right.
constexpr Row kWarnings[] = {
    {"z=u k=3", "k is defined, but nothing that is drawn depends on it", "", ""},
    {"z=1/u", "surface: the surface goes to infinity and is cut there: u = 0, v = -1:1", "", ""},
    {"z=1/u", "surface: clipped to z = ", "--clip off shows all of it", "z=1/u --clip off"},
    {"z=sign(u)", "surface: the surface jumps and is cut there: u = 0, v = -1:1", "", ""},
    {"z=atan2(v,u)", "surface: the surface has no limit at u = 0, v = 0", "", ""},
    {"z=sqrt(u)",
     "surface: 50 % of the domain is undefined and left out, at least outside of u = ", "", ""},
    {"mobius", "mobius: the surface is one-sided: front and back meet along a line", "", ""},
    {"z=u u=1:0", "surface: a range runs backwards, which swaps front and back", "", ""},
    {"sphere --max-triangles 100", "sphere: the limit of triangles stopped refinement",
     "--max-triangles allows more", "sphere --max-triangles 100000"},
    {"z=u --color 1/u", "surface: the colour goes to infinity; its range is cut to ", "", ""},
};

TEST_F(Messages, WarnOfWhatWouldMislead) {
  for (const Row& row : kWarnings) {
    const Outcome outcome = run(std::string(row.command) + " -o a.ply");
    EXPECT_EQ(outcome.status, 0) << row.command;
    EXPECT_TRUE(contains(outcome.err, std::string("saddle: warning: ") + row.message))
        << row.command << "\n"
        << outcome.err;
    EXPECT_TRUE(contains(outcome.err, row.hint)) << row.command << "\n" << outcome.err;
    if (std::string_view(row.instead).empty()) continue;
    EXPECT_FALSE(contains(run(std::string(row.instead) + " -o a.ply").err, row.message))
        << row.instead;
  }
}

}  // namespace
}  // namespace saddle
