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
    {"qqq -o a.toml", "no surface is called 'qqq'", "saddle list names the surfaces", "list"},
    {"help", "no surface is called 'help'", "did you mean --help?", "--help"},
    {"show torus sphere", "two scenes, 'torus' and 'sphere'", "torus + sphere",
     "show torus + sphere"},
    {"none.toml -o a.toml", "there is no file none.toml", "saddle list", "list"},
    {"torus --ortho yes -o a.toml", "no surface is called 'yes'", "saddle list names the surfaces",
     "torus --ortho -o a.toml"},
    {"torus sphere -o a.toml", "two scenes, 'torus' and 'sphere'", "torus + sphere",
     "torus + sphere -o a.toml"},
    {"z=u + v -o a.toml", "no surface is called 'v'", "in quotes if it has spaces: z='u + v'",
     "'z=u + v' -o a.toml"},
    {"z=u v -o a.toml", "no surface is called 'v'", "in quotes if it has spaces: z='u + v'",
     "'z=u*v' -o a.toml"},
    {"z=u +v -o a.toml", "no surface is called '+v'", "in quotes if it has spaces: z='u + v'",
     "'z=u + v' -o a.toml"},
    {"'sin(u)*cos(v)' -o a.toml", "no surface is called 'sin(u)*cos(v)'",
     "NAME=EXPRESSION, in quotes if it has spaces: z='sin(u)*cos(v)'",
     "z='sin(u)*cos(v)' -o a.toml"},
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
    {"z=u u=1:1 -o a.ply", "u: the range of u is empty", "both ends are 1", "z=u u=0:1 -o a.ply"},
    {"z=u u=0:v -o a.ply", "u: the range of u cannot depend on v", "the ends of v may depend on u",
     "z=u v=0:u -o a.ply"},
    {"z=u v=u:u -o a.ply", "v: the range of v is empty", "for example v=0:sin(u)",
     "z=u u=1:2 v=0:sin(u) -o a.ply"},
    {"z=u u=0:1/0 -o a.ply", "u: this end of the range is not a finite number", "", ""},
    {"z=u u=-180:180deg -o a.ply", "u: 'deg' is a unit, and numbers have none here",
     "angles are in radians: write 180*pi/180", "z=u u=-180*pi/180:180*pi/180 -o a.toml"},
    {"z=u*v t=0:3s --frames 3 -o f-%02d.png", "t: 's' is a unit, and numbers have none here",
     "write 3", "z=u*t t=0:3 --frames 1 -s 9x9 -o f-%02d.png"},
    // names that a definition would explain
    {"z=a*u -o a.ply", "z: unknown name 'a'", "a=1 defines it", "z=a*u a=1 -o a.ply"},
    {"z=u*v u=0:k -o a.ply", "u: unknown name 'k'", "k=1 defines it", "z=u*v u=0:k k=1 -o a.ply"},
    {"z=u --color k*z -o a.ply", "--color: unknown name 'k'", "k=1 defines it",
     "z=u --color k*z k=1 -o a.ply"},
    {"z=u + curve x=a*s -o a.obj", "x: unknown name 'a'", "a=1 defines it",
     "z=u + curve x=a*s a=1 -o a.obj"},
    {"z=2mm*u -o a.ply", "z: 'mm' is a unit, and numbers have none here", "write 2",
     "z=2*u -o a.ply"},
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
    {"z=1e999*u -o a.ply", "z: a number that is out of range", "numbers go from 5e-324 to 1.8e308",
     "z=1e3*u -o a.ply"},
    {"z=u⁻ -o a.ply", "z: a raised minus without a number", "write u^-1 or u⁻¹",
     "z=u⁻¹ u=1:2 -o a.ply"},
    {"z=u²^3 -o a.ply", "z: a power of a superscript", "write (u^2)^3 or u^(2^3)",
     "z=(u^2)^3 -o a.ply"},
    {"'z=u@2' -o a.ply", "z: a character that no formula has",
     "formulas are made of numbers, names, + - * / ^ ( ) , < > = & | ? :", "'z=u*2' -o a.ply"},
    {"z=u(v+1) -o a.ply", "z: 'u' is not a function", "for a product write u*(...)",
     "z=u*(v+1) -o a.ply"},
    {"'z=1 000*u' -o a.ply", "z: a space inside a number", "write 1000", "z=1000*u -o a.ply"},
    {"z=u=v -o a.ply", "z: an assignment inside a formula",
     "to compare, write ==", "z=u==v --samples 9x9 -o a.ply"},
    {"z=u?1 -o a.ply", "z: a '?' without its ':'", "write a ? b : c", "z=u>0?1:2 -o a.ply"},
    {"z=(u:1) -o a.ply", "z: a ':' without its '?'", "write a ? b : c", "z=(u>0?u:1) -o a.ply"},
    {"z=u+ -o a.ply", "z: the formula ends where an operand is expected",
     "add a number, a name or a bracket", "z=u+1 -o a.ply"},
    {"z=(u+)*2 -o a.ply", "z: an operand is missing here", "add a number, a name or a bracket",
     "z=(u+1)*2 -o a.ply"},
    {"z=u+*2 -o a.ply", "z: an operand is missing before '*'",
     "an operator stands between two operands", "z=u+1*2 -o a.ply"},
    {"'f(s,s)=s' z=f(u,v) -o a.ply", "f(s, s): two arguments are called 's'",
     "give each its own name", "'f(s,r)=s*r' z=f(u,v) -o a.ply"},
    {"'torus' --view '1, ,2' -o a.ply", "--view: the formula is empty",
     "write an expression, e.g. u*v", "torus --view 1,0,2 -o a.ply"},
    // sums over an index
    {"z=sum(u,v,n=1:3) -o a.ply", "z: 'sum' over an index takes one expression",
     "write sum(EXPRESSION, n=1:20)", "'z=sum(u, n=1:20)' -o a.ply"},
    {"z=sum(n*u,n=3) -o a.ply", "z: the index n has no range",
     "write n=1:20, from the first to the last", "z=sum(n*u,n=1:20) -o a.ply"},
    {"z=sum(,n=1:3) -o a.ply", "z: an operand is missing here", "add a number, a name", ""},
    {"z=sum(n,n=1:u) -o a.ply", "z: a bound of an index must be a constant",
     "it may use numbers, constants and parameters, not u, v or t",
     "z=u*sum(n,n=1:k) k=3 -o a.ply"},
    {"z=sum(n*u,n=1:2.5) -o a.ply", "z: a bound of an index must be a whole number, not 2.5",
     "write floor(...) around it", "z=sum(n*u,n=1:floor(2.5)) -o a.ply"},
    {"z=sum(sin(n*u),n=1:30000) -o a.ply",
     "z: sums and products over an index have more than 20000 terms in all",
     "30000 terms here; use fewer", ""},
    {"f(s)=sum(cos(n*s)*s,n=1:9000) z=f(u)+f(v)+f(u*v)+f(u+v) -o a.ply",
     "z: the formulas grow past 100000 operations", "use fewer terms of sums", ""},
    // ranges that depend on what they cannot
    {"z=u u=u:1 -o a.ply", "u: the range of u depends on itself",
     "both ends are constant expressions, for example u=0:2*pi", "z=u u=0:2*pi -o a.ply"},
    {"z=u v=v:1 -o a.ply", "v: the range of v depends on itself",
     "its ends may depend on u, for example v=0:sin(u)", "z=u u=1:2 v=0:sin(u) -o a.ply"},
    {"z=u u=-1e308:1e308 -o a.ply", "u: the range of u is too wide for its length to be a number",
     "", ""},
    {"z=u u=0:t -o a.ply", "u: the range of u is empty", "both ends are 0",
     "z=u u=0:t t=1 -o a.ply"},
    {"z=u --t 0:1 -o a.png", "--t: this is one moment", "a range of time is t=0:1",
     "z=u*t t=0:1 --frames 1 -s 9x9 -o a.gif"},
    {"xyz=(1,y,x) x=0:1 y=0:1 -o a.ply", "xyz: xyz gives x, too", "give the parameter another name",
     "xyz=(1,q,p) p=0:1 q=0:1 -o a.ply"},
};

/// Formulas whose bounds no sensible row of a table reaches.
TEST_F(Messages, OfFormulasThatAreTooLongNameTheBound) {
  const auto error = [&](const std::vector<std::string>& formulas) {
    std::vector<std::string> words = formulas;
    words.insert(words.end(), {"-o", "a.ply"});
    return error_of(saddle(words), 2);
  };
  const auto repeated = [](const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
  };
  EXPECT_TRUE(contains(error({"z=u" + repeated("+0.1234567890", 5100)}),
                       "z: the formula is longer than 64 KiB\n"));
  EXPECT_TRUE(contains(error({"z=u" + repeated("+u", 10'000)}),
                       "z: the formula has more than 20000 numbers, names and operators\n"));
  EXPECT_TRUE(contains(error({"z=" + repeated("(", 300) + "u" + repeated(")", 300)}),
                       "z: brackets are nested more than 256 deep\n"));
  std::vector<std::string> chain = {"z=a300*u"};
  for (int i = 300; i > 0; --i) {
    chain.push_back("a" + std::to_string(i) + "=a" + std::to_string(i - 1) + "+1");
  }
  chain.emplace_back("a0=1");
  EXPECT_TRUE(contains(error(chain), "definitions use each other more than 256 deep\n"));
  std::string calls = "z=0";
  for (int i = 0; i < 2100; ++i) calls += "+f(u," + std::to_string(i) + ")";
  EXPECT_TRUE(contains(error({"f(s,n)=sum(s,k=n:n)", calls}),
                       "functions are called with more than 2000 different constants\n"));
}

TEST_F(Messages, OfFormulasNameAWayOutThatWorks) {
  expect_errors(kRows, 2);
}

}  // namespace
}  // namespace saddle
