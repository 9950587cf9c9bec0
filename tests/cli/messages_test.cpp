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
    {"torus sphere -o a.toml", "two scenes, 'torus' and 'sphere'", "torus + sphere",
     "torus + sphere -o a.toml"},
    {"z=u + v -o a.toml", "no surface is called 'v'", "in quotes if it has spaces: z='u + v'",
     "'z=u + v' -o a.toml"},
    {"z=u v -o a.toml", "no surface is called 'v'", "in quotes if it has spaces: z='u + v'",
     "'z=u*v' -o a.toml"},
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
    // several objects
    {"torus + -o a.toml", "there is no object after the '+'", "saddle torus + z=u*v",
     "torus + z=u*v -o a.toml"},
    {"+ torus -o a.toml", "there is no object before the '+'", "saddle torus + z=u*v",
     "torus + z=u*v -o a.toml"},
    {"torus + --front red -o a.toml", "there is no object after the '+'", "saddle torus + z=u*v",
     "torus --front red -o a.toml"},
    {"z=a*u a=1 + z=a*v a=2 -o a.toml", "argument: two definitions of 'a': a=1 and a=2",
     "give one of them another name", "z=a*u a=1 + z=b*v b=2 -o a.toml"},
    {"z=u*t t=0:1 + z=v t=0:2 -o a.toml", "argument: two definitions of 't': t=0:1 and t=0:2",
     "leave one of them out", "z=u*t t=0:1 + z=v -o a.toml"},
    {"torus k=3 + sphere -o a.toml", "argument: torus has no 'k'", "known names: R r x y z u v t",
     "torus r=0.3 + sphere -o a.toml"},
    {"torus r=0.2 + z=u r=0.3 R=1 r=4 -o a.toml", "argument: 'r' is given twice",
     "leave one of them out", "torus r=0.2 + z=u*r r=4 -o a.toml"},
    {"u=0:1 + torus -o a.ply", "z has no formula", "z='sin(u)*cos(v)'",
     "u=0:1 'z=sin(u)*cos(v)' + torus -o a.toml"},
    {"torus --colormap magma + z=u --color u -o a.toml", "--colormap: there is nothing to colour",
     "--color z", "torus --colormap magma --color z + z=u --color u -o a.toml"},
    {"node2.toml + node2.toml -o a.toml", "the nodes of a second scene, 'saddle'",
     "name that scene first", "torus + node2.toml -o a.toml"},
    // names of parameters
    {"z=1 x=0:1 y=0:1 v=0:1 -o a.toml",
     "v: a surface has two parameters, and these are more: x, y and v",
     "leave one of the ranges out", "z=1 x=0:1 y=0:1 -o a.toml"},
    {"torus R=0:1 -o a.toml", "R: 'R' is a constant of torus, which has no range", "write R=1;",
     "torus R=1 -o a.toml"},
    {"torus x=0:1 -o a.toml", "x: 'x' is not a parameter of torus",
     "the parameters of torus are u and v: u=0:1", "torus u=0:1 -o a.toml"},
    {"z=x x=0:1 x=cos(u) -o a.toml", "argument: 'x' is given twice", "leave one of them out",
     "z=x x=0:1 -o a.toml"},
    {"z=1 sin=0:1 -o a.toml", "sin: 'sin' is a function of the language", "choose another name",
     "z=1 s=0:1 -o a.toml"},
    {"z=u*v x=0:1 y=0:1 -o a.ply", "z: unknown name 'u'", "known names: x y t",
     "z=x*y x=0:1 y=0:1 -o a.ply"},
    {"z=x x=0:y y=0:1 -o a.ply", "x: the range of x cannot depend on y",
     "the ends of y may depend on x: swap", "z=x x=0:1 y=0:x+1 -o a.ply"},
    {"z=x x=1:1 -o a.ply", "x: the range of x is empty", "for example x=0:2*pi",
     "z=x x=0:2*pi -o a.ply"},
    // regions
    {"z=u where=u+v -o a.ply", "where: this is a number, not a condition", "compare it: u+v < 1",
     "z=u 'where=u+v < 1' -o a.ply"},
    {"z=u where=foo<1 -o a.ply", "where: unknown name 'foo'", "known names: u v t x y", ""},
    {"z=u where=0:1 -o a.toml", "where: 'where' is the condition of a surface",
     "choose another name", ""},
    // ranges
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
    {"torus --color-range 0:1 -o a.toml", "--color-range: there is nothing to colour", "--color z",
     "torus --color-range 0:1 --color z -o a.toml"},
    {"torus --color z --color-range 2 -o a.toml", "--color-range: both ends are wanted", "0:1",
     "torus --color z --color-range 0:1 -o a.toml"},
    {"torus --color z --color-range 0:foo -o a.toml", "--color-range: unknown name 'foo'", "", ""},
    {"torus --color z --color-range 2:1 -o a.toml",
     "surface 1: color-range: the first end must be less than the second", "write 1:2",
     "torus --color z --color-range 1:2 -o a.toml"},
    {"torus --contours foo -o a.toml", "contours: unknown name 'foo'", "gauss mean", ""},
    {"torus --contours z=foo -o a.toml", "--contours: unknown name 'foo'", "known names", ""},
    {"torus --contours z=1, -o a.toml", "--contours: a level is missing", "z=0,0.5,1",
     "torus --contours z=0,0.5,1 -o a.toml"},
    {"torus --contours =1 -o a.toml", "--contours: the expression is missing", "EXPR=A,B,...",
     "torus --contours z=1 -o a.toml"},
    {"torus --contours z=1/0 -o a.toml", "--contours: not a finite number", "", ""},
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
    {"torus -o a.toml --report a.toml", "two outputs are called a.toml", "its own name",
     "torus -o a.toml --report b.json"},
    {"torus -o - --format ply --report -", "only one thing can go to standard output",
     "give the others a file", ""},
    {"torus --watch -o a.png", "--watch: only the viewer watches a file", "leave out --output", ""},
    {"torus --max-time 5", "--max-time: the viewer takes as long as it is open", "for outputs",
     "torus --max-time 500 -s 9x9 -o a.png"},
    {"torus --max-memory 5 -o a.png", "--max-memory: a size of memory has a unit", "2GB",
     "torus --max-memory 2GB -s 9x9 -o a.png"},
    {"torus --max-memory 5MB -o a.png", "--max-memory: must be from 64MB", "", ""},
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
    {"empty.toml -o a.toml", "empty.toml:1:1: the scene has no [[surface]], [[curve]] or [[point]]",
     "saddle show torus", "show torus"},
    {"node.toml -o a.toml", "node.toml:3:7: surface 1: in: no node is called 'wheel'",
     "the scene has no [[node]]", ""},
    {"twice.toml -o a.toml",
     "twice.toml:2:14: surface 1: parameters: both parameters are called 'p'",
     "give each its own name", ""},
    {"other.toml -o a.toml", "other.toml:4:1: unknown key 'u'", "p q", ""},
    {"plain.png -o a.toml", "plain.png is not a PNG file", "", ""},
    // curves and points
    {"curve u=s v=s -o a.toml", "u: there is no surface for u and v", "a surface stands before",
     "torus + curve u=s v=s -o a.toml"},
    {"torus + curve u=s -o a.toml", "u: v is missing", "has u and v",
     "torus + curve u=s v=0 -o a.toml"},
    {"curve x=3 -o a.toml", "the curve does not depend on s",
     "x='cos(s)' y='sin(s)' z='s/5' s=0:tau",
     "curve x='cos(s)' y='sin(s)' z='s/5' s=0:tau -o a.toml"},
    {"curve x=t t=0:1 -o a.toml", "the curve does not depend on s", "t is time", ""},
    {"torus + curve x=s u=s v=0 -o a.toml", "u: the curve has two places", "leave one of them out",
     "curve x=s -o a.toml"},
    {"curve -o a.toml", "the curve has no place", "x='cos(s)'", ""},
    {"curve x=s u=0:1 -o a.toml", "u: a curve has a range of s", "write s=0:1",
     "curve x=s s=0:1 -o a.toml"},
    {"curve x=s s=3 -o a.toml", "s: a range is MIN:MAX", "s=0:2*pi",
     "curve x=s s=0:2*pi -o a.toml"},
    {"curve x=s foo -o a.toml", "'foo' is no part of a curve", "curve x='cos(s)'", ""},
    {"curve x=s --front red -o a.toml", "--front: a curve takes no such option", "--color",
     "curve x=s --color red -o a.toml"},
    {"sphere --radius 0.1 -o a.toml", "--radius: there is no curve or point that takes it",
     "+ point 0,0,1 --radius 0.1", "sphere + point 0,0,1 --radius 0.1 -o a.toml"},
    {"sphere --radius 0.1 + point 1,2,3 -o a.toml", "--radius: there is no curve or point",
     "it stands behind one", "k=1 --radius 0.1 + sphere + point 1,2,k -o a.toml"},
    {"curve x=s --color z -o a.toml", "--color: unknown colour 'z'", "CSS colour name",
     "curve x=s --color tomato -o a.toml"},
    {"curve x=s --radius 0 -o a.toml", "--radius: must be more than 0", "", ""},
    {"point -o a.toml", "the point has no place", "point 1,2,3", "point 1,2,3 -o a.toml"},
    {"point 4,5 -o a.toml", "point: a place in space has three numbers, this one has 2",
     "for example point 1,2,3", "point 1,2,3 -o a.toml"},
    {"point x=1 -o a.toml", "x: the place of a point is one word", "point 1,2,3",
     "point 1,2,3 -o a.toml"},
    {"point 1,2,3 4,5,6 -o a.toml", "'4,5,6' is no part of a point", "point u=1 v=2", ""},
    {"on.toml -o a.toml", "on.toml:3:7: on: no surface is called 'tours'", "did you mean 'torus'?",
     ""},
};

TEST_F(Messages, NameTheMistakeAndAWayOutThatWorks) {
  std::ofstream(path("key.toml")) << "grif = 3\n";
  std::ofstream(path("type.toml")) << "title=3\n[[surface]]\nz = \"u\"\n";
  std::ofstream(path("toml.toml")) << "title = torus\n";
  std::ofstream(path("empty.toml")) << "title = \"nothing\"\n";
  std::ofstream(path("node.toml")) << "[[surface]]\nz = \"u\"\nin = \"wheel\"\n";
  std::ofstream(path("node2.toml"))
      << "[[surface]]\nz = \"u\"\nin = \"w\"\n[[node]]\nname = \"w\"\n";
  std::ofstream(path("twice.toml")) << "[[surface]]\nparameters = [\"p\", \"p\"]\nz = \"p\"\n";
  std::ofstream(path("other.toml"))
      << "[[surface]]\nparameters = [\"p\", \"q\"]\nz = \"p\"\nu = [0, 1]\n";
  std::ofstream(path("on.toml")) << "[[curve]]\nu = \"s\"\non = \"tours\"\nv = 0\n"
                                    "[[surface]]\nname = \"torus\"\nz = \"u\"\n";
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
    {"z=a*u a=2 + z=v b=3", "b is defined, but nothing that is drawn depends on it", "", ""},
    {"z=1/x x=-1:1 y=0:1", "surface: the surface goes to infinity and is cut there: x = 0, y = 0:1",
     "", ""},
    {"z=sqrt(x) x=-1:1 where=y<0", "surface: 25 % of the domain is undefined and left out inside",
     "", ""},
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
    {"curve x=s y=1/s s=-1:1 --radius 0.1",
     "curve: the curve goes to infinity and is cut there: s = 0", "", ""},
    {"curve x=s y=1/s s=-1:1 --radius 0.1", "curve: clipped to the box that most of it is in",
     "--clip off shows all", "curve x=s y=1/s s=-1:1 --radius 0.1 --clip off"},
    {"curve x=s y=sign(s) s=-1:1 --radius 0.1", "curve: the curve jumps and is cut there: s = 0",
     "", ""},
    {"curve x=s y=sqrt(s) s=-1:1 --radius 0.1", "curve: undefined over 50 % of the range of s", "",
     ""},
    {"sphere + point 1,2,3", "point: a mesh has no lines and dots", "--radius",
     "sphere + point 1,2,3 --radius 0.1"},
    {"z=u^2+v^2 --contours z=7", "surface: the contours of z: none at 7; it runs from 0 to 2", "",
     ""},
    {"z=1 --contours z", "surface: the contours of z: it is 1 on a whole area, which has no line",
     "", ""},
    {"z=u --contours sqrt(u-2)",
     "surface: the contours of sqrt(u-2): no level; it is nowhere a finite number", "", ""},
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
