// What each format of meshes costs beside PLY: a torus of a million vertices, written to a file
// among the temporary ones; and what assimp's export of the same mesh takes, where it is installed.
// Usage: saddle_exports. Exit 1 if a format takes longer than its limit, or more memory.
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <ostream>
#include <string>

#include "base/file.h"
#include "base/heap.h"
#include "export/formats/formats.h"
#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

constexpr int kRounds = 5;
constexpr int kSide = 1000;

/// Processor time of all threads, or of all commands that have ended, milliseconds.
double spent(__rusage_who by = RUSAGE_SELF) {
  rusage used{};
  getrusage(by, &used);
  const auto milliseconds = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return milliseconds(used.ru_utime) + milliseconds(used.ru_stime);
}

struct Row {
  const char* name;
  const char* extension;
  bool one_sheet;                ///< both sides of the surface are alike
  double limit;                  ///< times the PLY's
  const char* assimp = nullptr;  ///< assimp's name of the format; not set: it writes no mesh
};

// OBJ has three times PLY's bytes, and takes numbers to digits. 3MF deflates 150 MB, which takes
// zlib at its least effort 36 times PLY's time. A tenth above what is measured: machines differ.
constexpr Row kRows[] = {{"PLY", "ply", false, 1, "plyb"},
                         {"STL", "stl", false, 3, "stlb"},
                         {"GLB, one sheet", "glb", true, 2.3, "glb2"},
                         {"GLB, two sheets", "glb", false, 4.3},
                         {"OBJ", "obj", false, 12, "obj"},
                         {"3MF", "3mf", false, 40}};

/// The file that each writer writes.
std::filesystem::path written_file() {
  return std::filesystem::temp_directory_path() / ("saddle-exports-" + std::to_string(getpid()));
}

constexpr double kMostMemory = 64;  ///< megabytes above the mesh

/// Megabytes of a line of /proc/self/status, "VmRSS:" or "VmHWM:"; Linux alone has it.
double status_of(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == key && status >> kilobytes) return 1.024e-3 * kilobytes;
  }
  return 0;
}

/// Megabytes that writing a closed surface takes at most, beside the mesh. Finding shells is part
/// of it.
double memory_of(const Row& row, const MeshContent& content) {
  malloc_trim(0);  // memory of before that is free would hide what is taken again
  std::ofstream("/proc/self/clear_refs") << 5;  // the most so far becomes that of now
  const double before = status_of("VmRSS:");
  write_file_whole(written_file(), [&](std::ostream& out) {
    find_format(row.extension)->write_mesh(out, content);
  });
  std::filesystem::remove(written_file());
  return status_of("VmHWM:") - before;
}

/// The least time of several rounds, and the bytes.
double time_of(const Row& row, const MeshContent& content, std::uintmax_t& bytes) {
  const std::filesystem::path file = written_file();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRounds; ++i) {
    const double begin = spent();
    write_file_whole(
        file, [&](std::ostream& out) { find_format(row.extension)->write_mesh(out, content); });
    least = std::min(least, spent() - begin);
    bytes = std::filesystem::file_size(file);
    std::filesystem::remove(file);
  }
  return least;
}

/// The processor time of a command, milliseconds; nothing if it fails.
std::optional<double> time_of_command(const std::string& command) {
  const double begin = spent(RUSAGE_CHILDREN);
  if (std::system((command + " >/dev/null 2>&1").c_str()) != 0) return std::nullopt;
  return spent(RUSAGE_CHILDREN) - begin;
}

/// What assimp takes to export a mesh: what it takes for a file less what it takes to read it.
class Assimp {
 public:
  explicit Assimp(const MeshContent& content) {
    write_file_whole(read_,
                     [&](std::ostream& out) { find_format("ply")->write_mesh(out, content); });
    reading_ = time_of_command("assimp info " + read_.string() + " --raw");
  }
  Assimp(const Assimp&) = delete;
  Assimp& operator=(const Assimp&) = delete;
  ~Assimp() { std::filesystem::remove(read_); }

  std::optional<double> time_of(const char* format) const {
    if (!reading_ || format == nullptr) return std::nullopt;
    const std::filesystem::path written = written_file();
    const std::optional<double> time = time_of_command("assimp export " + read_.string() + " " +
                                                       written.string() + " -f" + format);
    std::filesystem::remove(written);
    if (!time) return std::nullopt;
    return *time - *reading_;
  }

 private:
  std::filesystem::path read_ = written_file().string() + ".ply";
  std::optional<double> reading_;
};

bool run() {
  Scene scene = gallery_scene(*find_gallery_entry("torus"));
  scene.surfaces[0].grid = GridSize{0, 0};
  scene.surfaces[0].u.max = "6";  // open, so that both sides can be seen
  scene.mesh.samples = GridSize{kSide, kSide};
  scene = resolve(scene);
  Purpose purpose;
  purpose.mesh = true;
  const Mesh mesh = tessellate(scene, scene.surfaces[0], purpose, 0).mesh;
  Scene whole = scene;
  whole.surfaces[0].u.max = "tau";  // closed: all that can be known of it is looked for
  whole = resolve(whole);
  const Mesh closed = tessellate(whole, whole.surfaces[0], purpose, 0).mesh;
  const std::vector<Shells> shells = {shells_of(mesh)};
  std::printf("%zu vertices, %zu triangles; milliseconds of processor time\n", mesh.position.size(),
              mesh.triangles.size());
  std::printf("%-16s %8s %8s %8s %8s %8s %8s\n", "format", "ms", "x PLY", "limit", "MB", "memory",
              "assimp");
  const Assimp assimp({{&mesh, 1}, scene, shells});
  double ply = 0;
  bool is_good = true;
  for (const Row& row : kRows) {
    Scene own = scene;
    if (row.one_sheet) own.surfaces[0].back = own.surfaces[0].front;
    std::uintmax_t bytes = 0;
    const double time = time_of(row, {{&mesh, 1}, own, shells}, bytes);
    if (ply == 0) ply = time;
    const double memory = memory_of(row, {{&closed, 1}, own});
    const bool is_slow = time > row.limit * ply;
    const bool is_large = memory > kMostMemory;
    is_good = is_good && !is_slow && !is_large;
    const std::optional<double> theirs = assimp.time_of(row.assimp);
    std::printf("%-16s %8.0f %8.1f %8.1f %8.1f %8.0f %8s%s%s\n", row.name, time, time / ply,
                row.limit, 1e-6 * static_cast<double>(bytes), memory,
                theirs ? std::to_string(std::lround(*theirs)).c_str() : "-",
                is_slow ? "  too slow" : "", is_large ? "  too large" : "");
  }
  return is_good;
}

}  // namespace
}  // namespace saddle

int main() {
  saddle::use_huge_pages();
  return saddle::run() ? 0 : 1;
}
