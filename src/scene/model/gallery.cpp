// The built-in surfaces. Closed ones and tubes have r_u x r_v pointing outward, so that their
// outside is the front.
// Source of most: A. Gray, "Modern Differential Geometry of Curves and Surfaces with Mathematica",
// 2006. Every formula is checked in tests/geometry/gallery/.
#include "scene/model/gallery.h"

#include <algorithm>
#include <array>

#include "base/nearest.h"
#include "scene/model/assignments.h"

namespace saddle {
namespace {

Camera from(const dvec3& view, const dvec3& up = {0, 0, 1}) {
  Camera camera;
  camera.view = view;
  camera.up = up;
  return camera;
}

/// The camera that the parametric function grapher's scene is drawn with.
Camera grapher_camera() {
  Camera camera = from({2, 1, 3}, {0, 1, 0});
  camera.target = dvec3{0, 0, 0};
  camera.distance = 24;
  camera.fov = 45;
  return camera;
}

constexpr Clip within(const dvec3& low, const dvec3& high) {
  return {false, Bounds{low, high}};
}

/// A function, so that the table is made when it is asked for first, not at every start.
// NOLINTNEXTLINE(readability-function-size): all of it is data
const auto& entries() {
  static const auto kEntries = std::to_array<GalleryEntry>({
      {.name = "eck-default",
       .description = "egg-box waves, the first scene of Eck's function grapher",
       .assignments = "x=u y=2*sin(u)*cos(2*v) z=v u=-6:6 v=-6:6",
       .camera = grapher_camera(),
       .flip = true,
       .size = GridSize{500, 500}},

      // Quadrics and surfaces of revolution.
      {"sphere", "sphere of radius r",
       "x=r*cos(u)*cos(v) y=r*sin(u)*cos(v) z=r*sin(v) u=0:2*pi v=-pi/2:pi/2 r=1"},
      {"ellipsoid", "ellipsoid with half-axes a, b and c",
       "x=a*cos(u)*cos(v) y=b*sin(u)*cos(v) z=c*sin(v) u=0:2*pi v=-pi/2:pi/2 a=3 b=2 c=1"},
      {"torus", "ring torus: a tube of radius r around a circle of radius R",
       "x=(R+r*cos(v))*cos(u) y=(R+r*cos(v))*sin(u) z=r*sin(v) u=0:2*pi v=0:2*pi R=2 r=0.8",
       from({2, -3, 3})},
      {"horn-torus", "torus whose hole is a point",
       "x=r*(1+cos(v))*cos(u) y=r*(1+cos(v))*sin(u) z=r*sin(v) u=0:2*pi v=0:2*pi r=1",
       from({2, -3, 3})},
      {"spindle-torus", "torus that passes through itself",
       "x=(R+r*cos(v))*cos(u) y=(R+r*cos(v))*sin(u) z=r*sin(v) u=0:2*pi v=0:2*pi R=0.6 r=1",
       from({2, -3, 3})},
      {"cylinder", "cylinder of radius r and height 2*h",
       "x=r*cos(u) y=r*sin(u) z=v*h u=0:2*pi v=-1:1 r=1 h=1"},
      {"cone-double", "both halves of a cone of slope h",
       "x=v*cos(u) y=v*sin(u) z=h*v u=0:2*pi v=-1:1 h=1"},
      {"hyperboloid-1", "hyperboloid of one sheet with waist a",
       "x=a*cosh(v)*cos(u) y=a*cosh(v)*sin(u) z=c*sinh(v) u=0:2*pi v=-1.5:1.5 a=1 c=1"},
      {"hyperboloid-2", "both sheets of a hyperboloid",
       "x=a*sinh(v)*cos(u) y=a*sinh(v)*sin(u) z=(v<0?-c:c)*cosh(v) u=0:2*pi v=-1.5:1.5 a=1 c=1"},
      {"paraboloid", "bowl z=a*(x^2+y^2)", "x=v*cos(u) y=v*sin(u) z=a*v^2 u=0:2*pi v=0:2 a=1",
       from({2, -3, 2.5})},
      {"hyperbolic-paraboloid", "the saddle z=a*x^2-b*y^2", "x=u y=v z=a*u^2-b*v^2 a=1 b=1"},
      {"monkey-saddle", "saddle for two legs and a tail", "x=u y=v z=a*(u^3-3*u*v^2) a=1"},
      {"gabriel-horn", "Gabriel's horn: finite volume, infinite area",
       "x=v y=a*cos(u)/v z=a*sin(u)/v u=0:2*pi v=1:20 a=1", from({-2, -1.2, 0.8})},
      {"funnel", "a logarithm turned around its pole",
       "x=v*cos(u) y=v*sin(u) z=a*ln(v) u=0:2*pi v=0:2 a=1"},
      {"eight-surface", "figure of eight turned around its axis",
       "x=cos(u)*sin(2*v) y=sin(u)*sin(2*v) z=h*sin(v) u=0:2*pi v=-pi/2:pi/2 h=1"},
      {"astroidal-ellipsoid", "ellipsoid with its coordinates cubed",
       "x=(a*cos(u)*cos(v))^3 y=(b*sin(u)*cos(v))^3 z=(c*sin(v))^3 u=0:2*pi v=-pi/2:pi/2 "
       "a=1 b=1 c=1"},
      {"pillow", "two sheets sewn together at the edges",
       "x=cos(u) y=cos(v) z=h*sin(u)*sin(v) u=0:pi v=-pi:pi h=0.5"},

      // Minimal surfaces.
      {"catenoid", "minimal surface between two circles, with waist c",
       "x=c*cosh(v)*cos(u) y=c*cosh(v)*sin(u) z=c*v u=0:2*pi v=-1.2:1.2 c=1"},
      {"helicoid", "minimal spiral staircase with pitch 2*pi*h",
       "x=v*cos(u) y=v*sin(u) z=h*u u=-pi:pi v=-1.5:1.5 h=0.5"},
      {"catenoid-helicoid", "bends a helicoid (t=0) into a catenoid (t=pi/2)",
       "x=cos(t)*sinh(v)*sin(u)+sin(t)*cosh(v)*cos(u) "
       "y=-cos(t)*sinh(v)*cos(u)+sin(t)*cosh(v)*sin(u) z=u*cos(t)+v*sin(t) u=-pi:pi v=-1.2:1.2"},
      {"enneper", "Enneper's minimal surface; passes through itself",
       "x=u-u^3/3+u*v^2 y=v-v^3/3+u^2*v z=u^2-v^2 u=-2:2 v=-2:2"},
      {"enneper-polar", "Enneper's surface of order n",
       "x=u*cos(v)-u^(2*n+1)*cos((2*n+1)*v)/(2*n+1) y=u*sin(v)+u^(2*n+1)*sin((2*n+1)*v)/(2*n+1) "
       "z=2*u^(n+1)*cos((n+1)*v)/(n+1) u=0:1.2 v=0:2*pi n=3"},
      {"enneper-order", "Enneper's surface of order n, from its Weierstrass data 1 and w^n",
       "xyz=(re(w-w^(2*n+1)/(2*n+1)),re(i*(w+w^(2*n+1)/(2*n+1))),re(2*w^(n+1)/(n+1))) w=u*e^(i*v) "
       "u=0:1.2 v=0:2*pi n=2"},
      {"scherk-1", "a cell of Scherk's first minimal surface",
       "x=u y=v z=ln(cos(v)/cos(u)) u=-1.5:1.5 v=-1.5:1.5"},
      {"scherk-1-chequerboard", "cells of Scherk's first minimal surface with poles around them",
       "x=u y=v z=ln(cos(v)/cos(u)) u=-a:a v=-a:a a=5", from({2, -3, 4}),
       within({-9, -9, -3}, {9, 9, 3})},
      {"scherk-2", "a piece of Scherk's tower",
       "x=u y=v z=asin(sinh(u)*sinh(v)) u=-0.75:0.75 "
       "v=-0.75:0.75"},
      {"scherk-2-tower", "the part of Scherk's tower that is a graph, with vertical rims",
       "x=u y=v z=asin(sinh(u)*sinh(v)) u=-a:a v=-a:a a=3", from({2, -3, 2})},
      {"henneberg", "Henneberg's one-sided minimal surface",
       "x=2*sinh(u)*cos(v)-2/3*sinh(3*u)*cos(3*v) y=2*sinh(u)*sin(v)+2/3*sinh(3*u)*sin(3*v) "
       "z=2*cosh(2*u)*cos(2*v) u=0.05:1 v=0:2*pi"},
      {"henneberg-band",
       "Henneberg's surface from its Weierstrass data, both halves: a Moebius band",
       "xyz=(re(w-w^3/3-1/w+w^-3/3),re(i*(w+w^3/3+1/w+w^-3/3)),re(w^2+w^-2)) w=e^(u+i*v) "
       "u=-0.8:0.8 v=0:pi",
       from({2, 2, 1})},
      {"catalan", "Catalan's minimal surface: its geodesic is a cycloid",
       "x=u-cosh(v)*sin(u) y=1-cos(u)*cosh(v) z=4*sin(u/2)*sinh(v/2) u=-2*pi:2*pi v=-1.5:1.5"},
      {"catalan-bjorling",
       "Bjoerling's formula with a cycloid (a,b) as a geodesic: Catalan's surface",
       "xyz=(re(a(w)),re(b(w)),im(l(w))) w=u+i*v a(s)=s-sin(s) b(s)=1-cos(s) l(s)=-4*cos(s/2) "
       "u=-2*pi:2*pi v=-1.5:1.5"},
      {"richmond", "Richmond's minimal surface, from Weierstrass's formula",
       "xyz=(re(-1/w-w^3/3)/2,re(i*(w^3/3-1/w))/2,re(w)) w=u*e^(i*v) u=0.5:1.3 v=0:2*pi",
       from({2, -3, 3})},
      {"bour", "Bour's minimal surface of three petals",
       "x=u*cos(v)-u^2*cos(2*v)/2 y=-u*sin(v)-u^2*sin(2*v)/2 z=4/3*u^1.5*cos(1.5*v) u=0:1 "
       "v=0:4*pi",
       from({2, -3, 3})},
      {"trinoid", "Jorge and Meeks's minimal surface with three catenoids as ends",
       "xyz=(re((w^2-w)/(w^3-1))/2-ln(abs((w-1)^2/(w^2+w+1)))/3,"
       "re(-i*(w+w^2)/(w^3-1))/2+ln(abs((w-o)/(w-conj(o))))/sqrt(3),re(-1/(w^3-1))) "
       "w=tan(v/2)*e^(i*u) o=e^(2*pi*i/3) u=0:2*pi v=0:pi where=abs(w^3-1)>c*max(1,abs(w)^3) c=0.4",
       from({1, -2, 2.5})},
      // Weierstrass's zeta Z and P of the square lattice from the theta series T; the factor A
      // makes the periods of the coordinates 0.
      {"chen-gackstatter", "Chen and Gackstatter's minimal surface: a torus with Enneper's end",
       "xyz=(re(A*(Q-g*w)*2/3+Z)/-2,re(i*(A*(Q-g*w)*2/3-Z))/2,re(sqrt(A)*P)) A=3*pi/(2*g) "
       "g=4*6.875185818020372^2 Z=diff(T,u)/T+pi*w P=-diff(Z,u) Q=diff(P,u) "
       "T=sum((-1)^n*e^(-pi*n*(n+1))*sin((2*n+1)*pi*w),n=0:4) w=u+i*v u=-0.5:0.5 v=-0.5:0.5 "
       "where=abs(P)<c c=20",
       from({3, 1, 1.2})},
      // By the logarithm l of Jacobi's |theta_1(p + iq)| on the square lattice: the slopes of a are
      // those of Weierstrass's zeta, b and c are the same half a period away, and b - c is half the
      // logarithm of |(P - e1) / (P + e1)|. h() takes p and q to the middle period, where four
      // terms
      // of the series hold a double's digits and the zero is exact.
      {"costa", "Costa's minimal surface: a torus with two funnels and a plane that go to infinity",
       "x=(pi/(2*e1)*diff(b-c,u)-diff(a,u))/2 y=(2*pi*v+pi/(2*e1)*(pi-diff(b-c,v))-diff(a,v))/2 "
       "z=sqrt(2*pi)/2*(b-c+pi/4-pi*v) u=0:1 v=0:1 "
       "a=l(u,v) b=l(u-1/2,v) c=l(u,v-1/2) e1=6.875185818020372 "
       "l(p,q)=ln(hypot(f(h(p),h(q)),g(h(p),h(q))))+pi*rint(q)*(2*q-rint(q)) h(s)=s-rint(s) "
       "f(p,q)=r(p,q,1)-r(p,q,3)+r(p,q,5)-r(p,q,7) g(p,q)=i(p,q,1)-i(p,q,3)+i(p,q,5)-i(p,q,7) "
       "r(p,q,k)=exp(pi*(1-k*k)/4)*sin(k*pi*p)*cosh(k*pi*q) "
       "i(p,q,k)=exp(pi*(1-k*k)/4)*cos(k*pi*p)*sinh(k*pi*q)",
       from({2, -2, 1.2}), within({-3, -3, -3}, {3, 3, 3})},

      // No curvature, and constant negative curvature.
      {"tangent-developable", "tangents of a helix of pitch 2*pi*b",
       "xyz=c(u)+v*diff(c(u),u) c(s)=(cos(s),sin(s),b*s) u=0:4*pi v=0:2 b=0.25"},
      {"pseudosphere", "tractrix turned around its axis: curvature -1/a^2",
       "x=a*cos(u)/cosh(v) y=a*sin(u)/cosh(v) z=a*(v-tanh(v)) u=0:2*pi v=-3:3 a=1"},
      {"dini", "twisted pseudosphere: curvature -1/(1+b^2)",
       "x=cos(u)*sin(v) y=sin(u)*sin(v) z=cos(v)+ln(tan(v/2))+b*u u=0:4*pi v=0.01:2 b=0.2"},
      {"kuen", "Kuen's surface: curvature -1",
       "x=2*cosh(v)*(cos(u)+u*sin(u))/w y=2*cosh(v)*(sin(u)-u*cos(u))/w "
       "z=v-2*sinh(v)*cosh(v)/w u=-4.5:4.5 v=-4:4 w=cosh(v)^2+u^2",
       from({3, 2, 1})},
      {"kuen-log", "Kuen's surface with the parameters of its lines of curvature",
       "x=2*(cos(u)+u*sin(u))*sin(v)/w y=2*(sin(u)-u*cos(u))*sin(v)/w z=ln(tan(v/2))+2*cos(v)/w "
       "u=-4.5:4.5 v=0.05:pi-0.05 w=1+u^2*sin(v)^2",
       from({3, 2, 1})},

      // One-sided surfaces.
      {"mobius", "Moebius band of width 2*w",
       "x=(1+v*cos(u/2))*cos(u) y=(1+v*cos(u/2))*sin(u) z=v*sin(u/2) u=0:2*pi v=-w:w w=0.5",
       from({2, -3, 2.5})},
      {"klein-figure8", "Klein bottle: a figure of eight turned by half a turn along a circle",
       "x=(R+p)*cos(u) y=(R+p)*sin(u) z=sin(u/2)*sin(v)+cos(u/2)*sin(2*v) u=0:2*pi v=0:2*pi R=2 "
       "p=cos(u/2)*sin(v)-sin(u/2)*sin(2*v)",
       from({2, -3, 2.5})},
      {"klein-bottle", "Klein bottle in the shape of a bottle",
       "x=6*cos(u)*(1+sin(u))+(u<pi?r*cos(u)*cos(v):-r*cos(v)) "
       "y=16*sin(u)+(u<pi?r*sin(u)*cos(v):0) z=r*sin(v) u=0:2*pi v=0:2*pi r=4*(1-cos(u)/2)",
       from({1, 0.5, 3}, {0, 1, 0})},
      {"lawson-klein", "Lawson's minimal Klein bottle of the 3-sphere, seen from a point off it",
       "xyz=(re(p),(im(p)-re(q))/sqrt(2),im(q))/(1-(im(p)+re(q))/sqrt(2)) p=cos(v)*e^(2*i*u) "
       "q=sin(v)*e^(i*u) u=0:pi v=0:2*pi",
       from({2, -3, 2.5})},
      {"cross-cap", "cross-cap: a projective plane with two pinch points",
       "x=cos(u)*sin(2*v) y=sin(u)*sin(2*v) z=cos(v)^2-cos(u)^2*sin(v)^2 u=0:pi v=0:pi"},
      {"roman", "Steiner's Roman surface with six pinch points",
       "x=sin(2*u)*cos(v)^2/2 y=sin(u)*sin(2*v)/2 z=cos(u)*sin(2*v)/2 u=0:pi v=0:pi",
       from({2, -3, 2.5})},
      {"boy", "Boy's surface: a projective plane without pinch points (Apery)",
       "x=(sqrt(2)*cos(v)^2*cos(2*u)+cos(u)*sin(2*v))/d "
       "y=(sqrt(2)*cos(v)^2*sin(2*u)-sin(u)*sin(2*v))/d z=3*cos(v)^2/d u=-pi/2:pi/2 v=0:pi "
       "d=2-sqrt(2)*sin(3*u)*sin(2*v)",
       from({2, -3, 2})},
      {"boy-bryant-kusner", "Boy's surface of the least bending (Bryant and Kusner)",
       "xyz=p/dot(p,p) p=(1.5*im(w*(w^4-1)/m),-1.5*re(w*(w^4+1)/m),im((w^6+1)/m)-0.5) "
       "m=w^6+sqrt(5)*w^3-1 w=tan(v/2)*e^(i*u) u=0:pi v=-pi/2:pi/2",
       from({2, -3, 2})},

      // Singularities.
      {"whitney-umbrella", "Whitney's umbrella: a pinch point", "x=u*v y=u z=v^2"},
      {"cuspidal-edge", "edge with a cusp", "x=u y=v^2 z=v^3", from({2, -3, 0.7})},
      {"swallowtail", "two cuspidal edges that meet",
       "x=u*v^2+3*v^4 y=-2*u*v-4*v^3 z=u u=-2:2 v=-0.8:0.8", from({-3, -2, 1.5})},
      {"menn", "Menn's surface", "x=u y=v z=a*u^4+u^2*v-v^2 a=0.5"},
      {"plucker-conoid", "Pluecker's conoid with n folds",
       "x=v*cos(u) y=v*sin(u) z=sin(n*u) u=0:2*pi v=0:1 n=2", from({3, 0.5, 2})},
      {"plucker-conoid-cartesian", "Pluecker's conoid as a graph, without a value at the origin",
       "x=u y=v z=a*u*v/(u^2+v^2) a=2", from({-2, -3, 2})},
      {"wallis-conical-edge", "Wallis's conical edge: lines from an axis to a curve above a circle",
       "x=v*cos(u) y=v*sin(u) z=c*sqrt(a^2-b^2*cos(u)^2) u=0:2*pi v=0:1 a=1 b=1 c=0.5",
       from({2, -3, 2.5})},
      {"riemann-sqrt", "Riemann surface of the square root",
       "x=u*cos(v) y=u*sin(v) z=h*sqrt(u)*cos(v/2) u=0:1 v=0:4*pi h=1", from({2, -3, 1.2})},
      {"riemann-cbrt", "Riemann surface of the cube root",
       "x=u*cos(v) y=u*sin(v) z=h*cbrt(u)*cos(v/3) u=0:1 v=0:6*pi h=1", from({2, -3, 2.5})},
      {"riemann-log", "Riemann surface of the logarithm, n turns",
       "x=u*cos(v) y=u*sin(v) z=h*v u=0.02:1 v=-n*pi:n*pi h=1/6 n=3", from({2, -3, 3})},
      {"riemann-asin", "Riemann surface of the arc sine",
       "x=sin(u)*cosh(v) y=cos(u)*sinh(v) z=u u=-pi:pi v=-1.5:1.5"},
      {"riemann-asin-imaginary", "imaginary part of the arc sine on its Riemann surface",
       "xyz=(re(sin(w)),im(sin(w)),im(w)) w=u+i*v u=0:2*pi v=-1.5:1.5", from({2, -3, 1})},
      {"riemann-conic", "Riemann surface of sqrt(z^2-1): two sheets, joined at 1 and -1",
       "xyz=(re(cosh(w)),im(cosh(w)),h*re(sinh(w))) w=u+i*v u=-1:1 v=0:2*pi h=1"},

      {"sine-modulus", "relief of the absolute value of sin(u + i*v)",
       "z=abs(sin(u+i*v)) u=-pi:pi v=-1.5:1.5", from({2, -3, 2})},
      // Stirling's series 16 further on, where it has a double's digits.
      {"gamma-modulus", "relief of the absolute value of gamma(u + i*v), after Jahnke and Emde",
       "z=e^re((s-0.5)*ln(s)-s+1/(12*s)-1/(360*s^3)+1/(1260*s^5)-1/(1680*s^7)+1/"
       "(1188*s^9))*sqrt(2*pi)"
       "/abs(prod(w+k,k=0:15)) s=w+16 w=u+i*v u=-3.5:4 v=-3:3",
       from({2, -3, 2}), within({-4, -3, 0}, {4, 3, 6.5})},
      // The alternating sum of Dirichlet's eta, whose terms have the weights of P. Borwein, 1995.
      {"zeta-modulus",
       "relief of the absolute value of Riemann's zeta: pole, three zeros; y is v/4",
       "xyz=(u,v/4,abs(sum((-1)^k*h(k)*(k+1)^-w,k=0:47)/(1-2^(1-w)))) w=u+i*v u=0.05:3 v=-3:26 "
       "h(k)=sum(b(j),j=k+1:48)/sum(b(j),j=0:48) b(j)=gamma(48+j)*4^j/(gamma(49-j)*gamma(2*j+1))",
       from({-3, -2, 2}), within({0, -1, 0}, {3, 7, 4})},
      {"weierstrass-function", "partial sum of Weierstrass's function without a derivative",
       "z=sum(a^n*cos(b^n*pi*u)*cos(b^n*pi*v),n=0:N)/4 u=0:1 v=0:1 a=0.5 b=3 N=3",
       from({2, -3, 4})},
      {"fourier-drum", "a square drum at the time t after it was plucked in the middle",
       "z=h*sum(sum(b(m)*b(n)*sin(m*u)*sin(n*v)*cos(hypot(m,n)*t),m=1:N),n=1:N) h=2 "
       "b(n)=8*sin(n*pi/2)/(pi*n)^2 N=15 u=0:pi v=0:pi t=0.8:7.8",
       from({2, -3, 2})},

      // Tubes, shells and other bodies.
      {"bohemian-dome", "an ellipse carried along another",
       "x=a*cos(u) y=b*cos(v)+a*sin(u) z=c*sin(v) u=0:2*pi v=0:2*pi a=0.5 b=1.5 c=1"},
      {"corkscrew", "twisted sphere of pitch 2*pi*b",
       "x=a*cos(u)*cos(v) y=a*sin(u)*cos(v) z=a*sin(v)+b*u u=0:2*pi v=-pi:pi a=1 b=0.5"},
      {"guimard", "the glass roof of a Paris metro entrance",
       "x=((1-u)*a+u*b)*cos(v) y=b*u*sin(v) z=c*u*sin(v)^2 u=0:1 v=0:2*pi a=1.5 b=0.5 c=1"},
      {"steinbach-screw", "Steinbach's screw", "x=u*cos(v) y=u*sin(v) z=v*cos(u) u=-4:4 v=0:2*pi",
       from({2, -3, 2})},
      {"bent-horns", "three pairs of horns",
       "x=(2+cos(u))*(v/3-sin(v)) y=(2+cos(u-2*pi/3))*(cos(v)-1) z=(2+cos(u+2*pi/3))*(cos(v)-1) "
       "u=-pi:pi v=-2*pi:2*pi"},
      {"trefoil-tube", "tube of radius r around a trefoil knot",
       "x=cx+r*(nx*sin(v)+bx*cos(v)) y=cy+r*(ny*sin(v)+by*cos(v)) z=cz+r*(nz*sin(v)+bz*cos(v)) "
       "u=0:2*pi v=0:2*pi r=0.6 cx=sin(u)+2*sin(2*u) cy=cos(u)-2*cos(2*u) cz=-sin(3*u) "
       "tx=diff(cx,u) ty=diff(cy,u) tz=diff(cz,u) ax=diff(tx,u) ay=diff(ty,u) az=diff(tz,u) "
       "p=ty*az-tz*ay q=tz*ax-tx*az s=tx*ay-ty*ax B=sqrt(p^2+q^2+s^2) bx=p/B by=q/B bz=s/B "
       "T=sqrt(tx^2+ty^2+tz^2) nx=(by*tz-bz*ty)/T ny=(bz*tx-bx*tz)/T nz=(bx*ty-by*tx)/T",
       from({1, -1.5, 3})},
      {"figure-eight-knot", "tube of radius r around the figure-eight knot",
       "xyz=tube(k,u,r,v) k=((2+cos(2*u))*cos(3*u),(2+cos(2*u))*sin(3*u),sin(4*u)) "
       "u=0:2*pi v=0:2*pi r=0.4",
       from({1, -1.5, 3})},
      {"torus-knot", "tube of radius r round a knot on a torus: a trefoil",
       "xyz=tube(k,u,r,v) k=((R+cos(q*u))*cos(p*u),(R+cos(q*u))*sin(p*u),sin(q*u)) u=0:2*pi "
       "v=0:2*pi "
       "p=2 q=3 R=2 r=0.4",
       from({1, -1.5, 3})},
      {"hopf-torus", "the circles of the 3-sphere that Hopf's map takes to a curve with n waves",
       "xyz=(re(p),im(p),re(q))/(1-im(q)) p=cos(s/2)*e^(i*v) q=sin(s/2)*e^(i*(u+v)) "
       "s=pi/2+a*sin(n*u) u=0:2*pi v=0:2*pi a=0.5 n=3",
       from({2, -1, 3})},
      {"dupin-cyclide", "Dupin's cyclide: a torus that is reflected in the sphere around c",
       "xyz=c-k*d/dot(d,d) d=((R+r*cos(v))*cos(u),(R+r*cos(v))*sin(u),r*sin(v))-c c=(a,0,0) "
       "u=0:2*pi "
       "v=0:2*pi R=2 r=0.8 a=4 k=9",
       from({1, -3, 3})},
      {"seashell", "a horn that grows along a spiral",
       "x=2*(1-exp(u/(6*pi)))*cos(u)*cos(v/2)^2 y=2*(exp(u/(6*pi))-1)*sin(u)*cos(v/2)^2 "
       "z=1-exp(u/(3*pi))+sin(v)-exp(u/(6*pi))*sin(v) u=0:6*pi v=0:2*pi"},
      {"conic-spiral", "a tube that winds up to a point (Nordstrand)",
       "x=a*(1-v/(2*pi))*cos(n*v)*(1+cos(u))+c*cos(n*v) "
       "y=a*(1-v/(2*pi))*sin(n*v)*(1+cos(u))+c*sin(n*v) z=v/(2*pi)-a*(1-v/(2*pi))*sin(u) "
       "u=0:2*pi v=0:2*pi a=0.2 c=0.1 n=2"},
      {"horn", "a tube that widens along a bend",
       "x=(2+u*cos(v))*sin(2*pi*u) y=(2+u*cos(v))*cos(2*pi*u)+2*u z=-u*sin(v) u=0:1 v=0:2*pi"},
      {"bourke-harmonic", "a harmonic of the sphere (Bourke)",
       "x=r*sin(v)*cos(u) y=r*cos(v) z=r*sin(v)*sin(u) u=0:2*pi v=0:pi "
       "r=sin(4*v)^3+cos(2*v)^3+sin(6*u)^2+cos(6*u)^4"},
      {"spherical-harmonic", "the spherical harmonic of degree 4 and order 3",
       "x=r*cos(v)*cos(u) y=r*cos(v)*sin(u) z=r*sin(v) u=0:2*pi v=-pi/2:pi/2 "
       "r=abs(cos(v)^3*sin(v)*cos(3*u))"},
      // The curves |a|^(2/e) + |b|^(2/e) = 1 are run through by angle: powers of sine and cosine
      // would be infinitely fast where one of them is 0, and would not come back to where they
      // began.
      {"superellipsoid", "ellipsoid with exponents 2/e: from a cube (e near 0) to a sphere (e=1)",
       "x=a*cv*cu y=b*cv*su z=c*sv u=0:2*pi v=-pi/2:pi/2 a=1 b=1 c=1 e=0.2 "
       "n(s)=(abs(cos(s))^(2/e)+abs(sin(s))^(2/e))^(-e/2) "
       "cu=cos(u)*n(u) su=sin(u)*n(u) cv=cos(v)*n(v) sv=sin(v)*n(v)"},
      {"superellipsoid-star", "ellipsoid with exponents 2/e, e above 1: a star, spiky for large e",
       "x=a*p(cos(v))*p(cos(u)) y=b*p(cos(v))*p(sin(u)) z=c*p(sin(v)) u=0:2*pi v=-pi/2:pi/2 "
       "p(s)=sign(s)*abs(s)^e a=1 b=1 c=1 e=3"},
      {"supertoroid", "torus whose two circles are superellipses with exponents 2/e",
       "x=(R+r*cv)*cu y=(R+r*cv)*su z=r*sv u=0:2*pi v=0:2*pi R=2 r=0.7 e=0.3 "
       "n(s)=(abs(cos(s))^(2/e)+abs(sin(s))^(2/e))^(-e/2) "
       "cu=cos(u)*n(u) su=sin(u)*n(u) cv=cos(v)*n(v) sv=sin(v)*n(v)",
       from({2, -3, 3})},
  });
  return kEntries;
}

/// sin(u)*cos(v), but not +v or my-surface
bool looks_like_formula(const std::string& word) {
  return word.find_first_of("(^") != std::string::npos && word.find('\'') == std::string::npos;
}

}  // namespace

std::span<const GalleryEntry> gallery() {
  return entries();
}

const GalleryEntry* find_gallery_entry(std::string_view name) {
  const auto entries = gallery();
  const auto found = std::ranges::find(entries, name, &GalleryEntry::name);
  return found == entries.end() ? nullptr : &*found;
}

Scene gallery_scene(const GalleryEntry& entry) {
  Scene scene;
  scene.title = entry.name;
  SurfaceSpec& spec = scene.surfaces.emplace_back();
  spec.name = entry.name;
  scene.camera = entry.camera;
  scene.clip = entry.clip;
  spec.flip = entry.flip;
  if (entry.size) {
    scene.picture.width = entry.size->u;
    scene.picture.height = entry.size->v;
  }
  for (std::size_t begin = 0; begin < entry.assignments.size();) {
    const std::size_t end = std::min(entry.assignments.find(' ', begin), entry.assignments.size());
    assign(scene, std::string(entry.assignments.substr(begin, end - begin)));
    begin = end + 1;
  }
  return scene;
}

Error unknown_gallery_name(const std::string& name) {
  std::vector<std::string> names;
  for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
  Hint hint;
  const std::string meant = did_you_mean(similar_names(name, names));
  if (meant.empty()) {
    const std::string formula = looks_like_formula(name) ? name : "u + v";
    hint.add("saddle list names the surfaces of the gallery");
    hint.add("a formula is NAME=EXPRESSION, in quotes if it has spaces: z='" + formula + "'");
  } else {
    hint.add(meant + " saddle list prints all names");
  }
  return {Status::Input, "no surface is called '" + name + "'", {}, hint};
}

}  // namespace saddle
