// Surfaces with a thickness: closed, oriented, two-manifold, and of the right volume.
#include "mesh/solid/thicken.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "geometry/gallery/samples.h"
#include "geometry/gallery/table.h"
#include "mesh/model/topology.h"
#include "mesh/solid/solid_facts.h"
#include "mesh_checks.h"
#include "meshing/solids.h"
#include "meshing/tessellate.h"
#include "meshing/thickness.h"
#include "random_formula.h"
#include "surface_from_text.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

using Directed = std::pair<std::uint32_t, std::uint32_t>;

/// Why triangles of these points are no closed, oriented two-manifold; empty: they are one. Each
/// directed side is there once, and so is its reverse; the triangles at a point are one ring.
std::string manifold_defect(const std::vector<Triangle>& triangles) {
  std::map<Directed, std::uint32_t> apex;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Directed side = {t[k], t[(k + 1) % 3]};
      if (side.first == side.second) return "a triangle with two corners at one point";
      if (!apex.emplace(side, t[(k + 2) % 3]).second) return "a directed side twice";
    }
  }
  std::map<std::uint32_t, std::size_t> sides_at;
  for (const auto& [side, third] : apex) {
    if (!apex.contains({side.second, side.first})) return "a side of one triangle";
    ++sides_at[side.first];
  }
  std::set<std::uint32_t> walked;
  for (const auto& [side, third] : apex) {
    if (!walked.insert(side.first).second) continue;
    std::size_t steps = 0;
    std::uint32_t to = side.second;
    do {
      to = apex.at({side.first, to});
      ++steps;
    } while (to != side.second);
    if (steps != sides_at[side.first]) return "a point with several rings of triangles";
  }
  return "";
}

std::string manifold_defect(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({mesh.point[a], mesh.point[b], mesh.point[c]});
  }
  return manifold_defect(triangles);
}

/// Points by their positions as floats, which is all that some formats keep.
std::vector<Triangle> welded_by_position(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  const auto point = [&](std::uint32_t corner) {
    const glm::vec3 p(mesh.position[corner]);
    return known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(known.size()))
        .first->second;
  };
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({point(a), point(b), point(c)});
  return triangles;
}

Mesh sheet_of(const Scene& scene) {
  return tessellate(scene, scene.surfaces.at(0), {.mesh = true}, 0).mesh;
}

Mesh sheet_of(const std::string& x, const std::string& y, const std::string& z,
              const Domain& domain, double share = 1e-3) {
  const Surface surface = surface_from_text(x, y, z, domain, {}, Order::Second);
  return try_mesh(surface, within_share(share))->mesh;
}

double fixed_thickness(const Mesh& sheet) {
  return sheet.bounds.diagonal() / 50;
}

Thickening both_sides(double total) {
  return {total / 2, total / 2};
}

TEST(Solid, OfEachSurfaceOfTheGalleryIsAClosedOrientedManifold) {
  ASSERT_EQ(gallery_facts().size(), gallery().size());
  std::size_t welded = 0;
  for (const GalleryFacts& facts : gallery_facts()) {
    const Mesh sheet = sheet_of(scene_of(facts.name));
    const Mesh solid = thicken(sheet, both_sides(fixed_thickness(sheet)));
    EXPECT_EQ(manifold_defect(solid), "") << facts.name;
    EXPECT_GT(volume(solid), 0) << facts.name;
    const Topology of_sheet = topology(sheet);
    const Topology of_solid = topology(solid);
    EXPECT_TRUE(of_solid.is_closed() && of_solid.orientable) << facts.name;
    if (of_sheet.pinched_points == 0 && of_sheet.shared_edges == 0) {
      EXPECT_EQ(of_solid.euler_number, 2 * of_sheet.euler_number) << facts.name;
      // A border joins front and back; without one there is a hollow, unless there is one side.
      const bool hollow = of_sheet.is_closed() && of_sheet.orientable;
      if (hollow) {
        EXPECT_EQ(of_solid.components, 2 * of_sheet.components) << facts.name;
      }
    }
    welded += manifold_defect(welded_by_position(solid)).empty() ? 1 : 0;
  }
  EXPECT_GE(welded, gallery().size() - 2);  // formats without points of their own keep nearly all
}

TEST(Solid, OfOneSideIsClosedToo) {
  for (const Thickening& way : {Thickening{0.1, 0}, Thickening{0, 0.1}}) {
    const Mesh sheet = sheet_of(scene_of("catenoid"));
    const Mesh solid = thicken(sheet, way);
    EXPECT_EQ(manifold_defect(solid), "");
    EXPECT_GT(volume(solid), 0);
  }
  EXPECT_THROW(thicken(sheet_of(scene_of("mobius")), {0.1, 0}), Error);
}

TEST(Solid, HasTheVolumeThatSteinersFormulaGives) {
  // T A + T^3/12 of the integrated Gauss curvature: 0 for a torus, 4 pi for a sphere.
  const double t = 0.2;
  double last = 1;
  for (const auto& [share, off] : {std::pair{1e-3, 0.1}, {1e-4, 1e-2}, {1e-5, 1e-3}}) {
    const Mesh torus = sheet_of("(1+0.4*cos(v))*cos(u)", "(1+0.4*cos(v))*sin(u)", "0.4*sin(v)",
                                {0, 2 * kPi, 0, 2 * kPi}, share);
    const double exact = t * 4 * kPi * kPi * 0.4;
    const double error = std::abs(volume(thicken(torus, both_sides(t))) - exact);
    EXPECT_LT(error, off * exact);
    EXPECT_LT(error, 0.3 * last);
    last = error;
  }
  const Mesh sphere =
      sheet_of("cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)", {0, 2 * kPi, -kPi / 2, kPi / 2}, 1e-5);
  const double shell = t * 4 * kPi + t * t * t / 12 * 4 * kPi;
  EXPECT_NEAR(volume(thicken(sphere, both_sides(t))), shell, 1e-3 * shell);
}

TEST(Solid, OfAFlatSquareIsABox) {
  const Mesh sheet = sheet_of("u", "v", "0", {0, 1, 0, 1});
  const Mesh solid = thicken(sheet, {0.25, 0.5});
  EXPECT_NEAR(volume(solid), 0.75, 1e-12);
  EXPECT_EQ(solid.bounds.low, dvec3(0, 0, -0.5));
  EXPECT_EQ(solid.bounds.high, dvec3(1, 1, 0.25));
  EXPECT_EQ(count_crossings(solid, 1).pairs, 0U);
}

TEST(Solid, MitresItsCreasesAndTips) {
  // A roof of 90 degrees: the front's ridge is sqrt(2) T/2 above, so that both slopes are T thick.
  Scene scene = scene_of("hyperbolic-paraboloid");
  scene.surfaces.at(0).z = "-abs(u)";
  const Mesh roof = sheet_of(scene);
  const double slopes = std::sqrt(2) * roof.bounds.size().x * roof.bounds.size().y;
  const Mesh solid = thicken(roof, both_sides(0.2));
  EXPECT_NEAR(solid.bounds.high.z, 0.1 * std::sqrt(2), 1e-9);
  EXPECT_NEAR(volume(solid), 0.2 * slopes, 1e-9);
  // A cone's tip moves along its axis.
  const Mesh cone = sheet_of("u*cos(v)", "u*sin(v)", "-u", {0, 1, 0, 2 * kPi});
  const Mesh thick_cone = thicken(cone, both_sides(0.2));
  const double top = std::max(thick_cone.bounds.high.z, -thick_cone.bounds.low.z - 1);
  EXPECT_NEAR(top, 0.1 * std::sqrt(2), 0.01);
}

TEST(Solid, KeepsParametersLinesAndNormalsOfItsSides) {
  const Mesh sheet = sheet_of(scene_of("monkey-saddle"));
  const Mesh solid = thicken(sheet, both_sides(0.1));
  ASSERT_TRUE(solid.solid);
  EXPECT_EQ(solid.solid->front, sheet.triangles.size());
  EXPECT_EQ(solid.solid->back, sheet.triangles.size());
  EXPECT_EQ(solid.solid->front + solid.solid->back + solid.solid->walls, solid.triangles.size());
  EXPECT_EQ(solid.lines.size(), 2 * sheet.lines.size());
  std::size_t against = 0;
  for (const Triangle& t : solid.triangles) {
    const dvec3 face = doubled_area(solid, t);
    for (const std::uint32_t corner : t) {
      if (glm::dot(face, solid.normal[corner]) <= 0) ++against;
    }
  }
  EXPECT_EQ(against, 0U);
  for (std::size_t i = 0; i < sheet.position.size(); ++i) {
    EXPECT_EQ(solid.uv[i], sheet.uv[i]);
    EXPECT_EQ(solid.normal[i], sheet.normal[i]);
    EXPECT_EQ(solid.normal[i + sheet.position.size()], -sheet.normal[i]);
  }
}

/// Three or four half planes that meet at a line: no two of them are a sheet by themselves.
Mesh book(const std::vector<double>& angles) {
  Mesh mesh;
  mesh.point_count = 2;
  for (const double angle : angles) {
    const dvec3 out(std::cos(angle), std::sin(angle), 0);
    const auto first = static_cast<std::uint32_t>(mesh.position.size());
    const std::array<dvec3, 4> corners = {dvec3(0), dvec3(0, 0, 1), out + dvec3(0, 0, 1), out};
    for (std::size_t k = 0; k < 4; ++k) {
      mesh.position.push_back(dvec3(corners[k]));
      mesh.normal.push_back(glm::cross(dvec3(0, 0, 1), out) * -1.0);
      mesh.uv.push_back({0, 0});
      mesh.point.push_back(k < 2 ? static_cast<std::uint32_t>(k) : mesh.point_count++);
      mesh.bounds.add(corners[k]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

TEST(Solid, PartsSheetsThatShareAnEdge) {
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 6U}) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < count; ++k) angles.push_back(2 * kPi * double(k) / double(count));
    const Mesh solid = thicken(book(angles), both_sides(0.1));
    EXPECT_EQ(manifold_defect(solid), "") << count;
    // Opposite pages go on straight as one sheet.
    EXPECT_EQ(topology(solid).components, (count + 1) / 2) << count;
  }
}

TEST(Solid, OfTrianglesWithoutAnyOrderIsStillAManifold) {
  // Random triangles on few points: sheets that cross, pinch, touch and have no consistent side.
  std::uint64_t key = 0;
  const auto real = [&key] { return 2 * random_unit(++key) - 1; };
  for (int round = 0; round < 200; ++round) {
    Mesh mesh;
    mesh.point_count = 9;
    for (std::uint32_t p = 0; p < mesh.point_count; ++p) {
      mesh.position.push_back({real(), real(), real()});
      mesh.normal.push_back(glm::normalize(dvec3(real(), 0.3, real())));
      mesh.uv.push_back({0, 0});
      mesh.point.push_back(std::uint32_t{p});
    }
    for (int k = 0; k < 3 + round % 20; ++k) {
      const auto pick = [&] { return static_cast<std::uint32_t>(9 * random_unit(++key)); };
      mesh.triangles.push_back({pick(), pick(), pick()});
    }
    for (const dvec3& p : mesh.position) mesh.bounds.add(p);
    EXPECT_EQ(manifold_defect(thicken(mesh, both_sides(0.01))), "") << round;
  }
}

/// As other programs read it: triangles of float positions, without point numbers.
void write_stl(const Mesh& mesh, const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  out << std::string(80, ' ');
  const auto put = [&out](const auto& value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    put(glm::vec3(0));
    for (const std::uint32_t corner : t) put(glm::vec3(mesh.position[corner]));
    put(std::uint16_t{0});
  }
}

TEST(Solid, NeedsNoRepairByAdmesh) {
  if (std::system("admesh --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no admesh here";
  const TemporaryFolder scratch;
  const std::filesystem::path& folder = scratch.path();
  for (const char* const name :
       {"torus", "mobius", "boy", "klein-bottle", "cone-double", "bourke-harmonic", "costa"}) {
    const Mesh sheet = sheet_of(scene_of(name));
    const std::filesystem::path file = folder / (std::string(name) + ".stl");
    write_stl(thicken(sheet, both_sides(fixed_thickness(sheet))), file);
    const std::filesystem::path said = folder / "said";
    const std::string command = "admesh " + file.string() + " > " + said.string() + " 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << name;
    const std::string text = std::regex_replace(read_file(said), std::regex(" +"), " ");
    for (const char* const line :
         {"Total disconnected facets : 0", "Degenerate facets : 0", "Edges fixed : 0",
          "Facets removed : 0", "Facets added : 0", "Facets reversed : 0", "Backwards edges : 0"}) {
      EXPECT_NE(text.find(line), std::string::npos) << name << ": " << line << text;
    }
  }
}

TEST(Solid, OfRandomFormulasIsAManifold) {
  int meshed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    testing::RandomFormula formula(seed);
    Scene scene = gallery_scene(*find_gallery_entry("hyperbolic-paraboloid"));
    SurfaceSpec& spec = scene.surfaces.at(0);
    spec.x = seed % 3 == 0 ? formula(2) : "u";
    spec.y = seed % 3 == 0 ? formula(2) : "v";
    spec.z = formula(3);
    scene.mesh.tolerance = ToleranceValue{0.02};
    scene.mesh.max_triangles = 3000;
    try {
      const Mesh sheet = sheet_of(scene);
      ++meshed;
      EXPECT_EQ(manifold_defect(thicken(sheet, both_sides(fixed_thickness(sheet)))), "")
          << spec.x << " | " << spec.y << " | " << spec.z;
    } catch (const Error& error) {
      EXPECT_NE(error.status(), Status::Machine) << spec.z;
    }
  }
  EXPECT_GT(meshed, 20);
}

TEST(SolidFacts, CountTrianglesThatGoThroughEachOther) {
  const Mesh plane = sheet_of("u", "v", "0", {-1, 1, -1, 1});
  EXPECT_EQ(count_crossings(plane, 1).pairs, 0U);
  Mesh both = plane;  // and a triangle that stands upright in it
  const auto first = static_cast<std::uint32_t>(both.position.size());
  for (const dvec3& p : {dvec3(0.11, 0.13, -1), dvec3(0.12, 0.13, 1), dvec3(0.115, 0.14, 1)}) {
    both.position.push_back(dvec3(p));
    both.point.push_back(both.point_count++);
  }
  both.triangles.push_back({first, first + 1, first + 2});
  EXPECT_EQ(count_crossings(both, 1).pairs, 1U);
  // By brute force, and on any number of threads.
  const Mesh boy = sheet_of(scene_of("boy", {}));
  const Crossings crossings = count_crossings(boy, 1);
  EXPECT_TRUE(crossings.are_all);
  EXPECT_GT(crossings.pairs, 100U);
  EXPECT_EQ(count_crossings(boy, 3).pairs, crossings.pairs);
}

/// Needles that all go through one point's surroundings: nearly each of them crosses each.
TEST(SolidFacts, CountNoMoreCrossingsThanTheirWorkIsBoundedFor) {
  constexpr std::uint32_t kNeedles = 1000;
  Mesh bundle;
  for (std::uint32_t k = 0; k < kNeedles; ++k) {
    const double angle = kPi * k / kNeedles;
    const dvec3 way(std::cos(angle), std::sin(angle), 0);
    const dvec3 beside = 1e-3 * dvec3(-way.y, way.x, 0);
    const dvec3 up(0, 0, 1e-6 * k);
    for (const dvec3& p : {-way + up, way + beside + up, way - beside + dvec3(0, 0, 0.1)}) {
      bundle.position.push_back(dvec3(p));
      bundle.point.push_back(bundle.point_count++);
    }
    bundle.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Crossings crossings = count_crossings(bundle, 1);
  EXPECT_FALSE(crossings.are_all);
  EXPECT_GT(crossings.pairs, 10 * kNeedles);
  EXPECT_LT(crossings.pairs, 130 * kNeedles);  // of some 500,000
  const Crossings again = count_crossings(bundle, 3);
  EXPECT_EQ(again.pairs, crossings.pairs);
  EXPECT_EQ(again.are_all, crossings.are_all);
}

TEST(SolidFacts, TellShellsVolumeAndClosedness) {
  const Mesh solid = thicken(sheet_of(scene_of("sphere")), both_sides(0.1));
  const SolidFacts facts = solid_facts(solid, 1);
  EXPECT_TRUE(facts.closed);
  EXPECT_EQ(facts.shells, 2U);
  EXPECT_NEAR(facts.volume, volume(solid), 1e-9);
  EXPECT_EQ(facts.crossings.pairs, 0U);
  EXPECT_FALSE(solid_facts(sheet_of(scene_of("catenoid")), 1).closed);
}

TEST(Thickness, InMillimetresIsThatOfThePrint) {
  EXPECT_EQ(units_per_millimetre({}, [](double) { return 7.0; }), 1);
  // A sphere of radius 3 in a print of 60 mm with walls of 2 mm: 6 + 2 x = 60 x.
  const auto sphere = [](double unit) { return 6 + 2 * unit; };
  EXPECT_NEAR(units_per_millimetre(60.0, sphere), 6.0 / 58, 1e-12);
  // Another side becomes the longest.
  const auto two = [](double unit) { return std::max(6.0, 5 + 20 * unit); };
  const double unit = units_per_millimetre(60.0, two);
  EXPECT_NEAR(60 * unit, two(unit), 1e-10);
  EXPECT_THROW(units_per_millimetre(2.0, sphere), Error);
  EXPECT_THROW(units_per_millimetre(1.0, sphere), Error);
}

TEST(Thickness, OfAPrintFitsIntoItsSize) {
  Scene scene = scene_of("sphere");
  scene.mesh.thickness = Thickness{3.0, true};
  scene.mesh.print_size = Number(50);
  Tessellation made = tessellate(scene, scene.surfaces[0], {.mesh = true}, 0);
  std::array<Tessellation*, 1> all = {&made};
  thicken_scene(scene, all, true, 0);
  const double longest = largest_of(made.mesh.bounds.size());
  EXPECT_NEAR(made.solid->thickness, 3 * longest / 50, 1e-9);
}

TEST(Thickness, HasALimitWhereTheSurfaceBends) {
  const auto limit = [](const std::string& name, Thickness::Where where) {
    Scene scene = scene_of(name);
    scene.mesh.thickness = Thickness{0.1, false, where};
    Tessellation made = tessellate(scene, scene.surfaces[0], {.mesh = true}, 0);
    std::array<Tessellation*, 1> all = {&made};
    thicken_scene(scene, all, true, 0);
    return made.solid->largest_thickness;
  };
  const Mesh sphere = sheet_of(scene_of("sphere"));
  const double radius = 0.5 * sphere.bounds.size().z;
  EXPECT_NEAR(limit("sphere", Thickness::Where::Both), 2 * radius, 1e-6);
  EXPECT_NEAR(limit("sphere", Thickness::Where::Back), radius, 1e-6);
  EXPECT_TRUE(std::isinf(limit("sphere", Thickness::Where::Front)));
  EXPECT_NEAR(limit("torus", Thickness::Where::Both), 1.6, 1e-9);  // the tube's radius is 0.8
}

}  // namespace
}  // namespace saddle
