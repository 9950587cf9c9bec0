// Messages about names, assignments, ranges and formulas of the command line.
#include "cli/messages.h"

namespace saddle {
namespace {

constexpr MessageRow kRows[] = {
    // names of surfaces
    {"klein -o a.toml", "no surface is called 'klein'",
     "'klein-figure8', 'klein-bottle' or 'lawson-klein'?", "klein-bottle -o a.toml"},
    {"mobius-strip -o a.toml", "no surface is called 'mobius-strip'", "did you mean 'mobius'?",
     "mobius -o a.toml"},
    {"helicod -o a.toml", "no surface is called 'helicod'", "did you mean 'helicoid'",
     "helicoid -o a.toml"},
    {"qqq -o a.toml", "no surface is called 'qqq'", "known surfaces: eck-default ", "list"},
    {"help", "no surface is called 'help'", "did you mean --help?", "--help"},
    {"show torus sphere", "two scenes, 'torus' and 'sphere'", "torus + sphere",
     "show torus + sphere"},
    {"none.toml -o a.toml", "there is no file none.toml", "saddle list", "list"},
    {"torus --ortho yes -o a.toml", "no surface is called 'yes'",
     "known surfaces:", "torus --ortho -o a.toml"},
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
    {"z=5! -o a.ply", "z: a factorial", "write gamma(5+1)", "z=gamma(5+1)+u -o a.ply"},
    {"z=u%2 -o a.ply", "z: '%' is not part of the language", "mod(a,b)", "z=mod(u,2) -o a.ply"},
    {"z=πu -o a.ply", "z: an operator is missing", "write π*u", "z=π*u -o a.ply"},
    {"z=mod(u) -o a.ply", "z: 'mod' takes 2 arguments, not 1", "", ""},
};

TEST_F(Messages, OfFormulasNameAWayOutThatWorks) {
  expect_errors(kRows, 2);
}

}  // namespace
}  // namespace saddle
