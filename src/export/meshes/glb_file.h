// The container of GLB files: a JSON chunk, and a chunk of bytes that is written piece by piece.
// Source: Khronos Group, "glTF 2.0 specification", 2021, chapters 3.6 and 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "export/common/writers.h"

namespace saddle {

/// Numbers of glTF.
enum class GlbComponent { U16 = 5123, U32 = 5125, Float = 5126 };
enum class GlbTarget { None = 0, Vertices = 34962, Indices = 34963 };

class GlbFile {
 public:
  using Json = nlohmann::ordered_json;
  using Write = std::function<void(ByteWriter&)>;

  /// All but buffers, views and accessors, which are added.
  Json json = Json::object();

  /// Adds a piece of so many bytes, which `write` writes later. Returns its bufferView.
  std::size_t add_view(std::size_t bytes, GlbTarget target, Write write);
  /// Adds `count` elements that are all of a view. Returns the accessor. `limits`: min and max.
  std::size_t add_accessor(std::size_t view, GlbComponent component, std::size_t count,
                           const char* type, const Json& limits = {});

  /// Throws Error (Input) for a file past 4 GiB. Each piece is written as it comes.
  void write(std::ostream& out);

 private:
  struct Piece {
    std::size_t bytes;
    Write write;
  };
  std::vector<Piece> pieces_;
  std::size_t bytes_ = 0;
};

/// The JSON of a GLB file's bytes. Throws Error (Input) for a file that is none; messages call it
/// `name`.
nlohmann::ordered_json json_of_glb(const std::string& bytes, const std::string& name);

}  // namespace saddle
