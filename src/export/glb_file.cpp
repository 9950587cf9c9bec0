#include "export/glb_file.h"

#include <cstring>
#include <limits>
#include <ostream>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace saddle {
namespace {

constexpr std::uint32_t kGltfVersion = 2;
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kByteChunk = 0x004E4942;  // "BIN"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::size_t aligned(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) {
    number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return number;
}

}  // namespace

std::size_t GlbFile::add_view(std::size_t bytes, GlbTarget target, Write write) {
  Json view = {{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", bytes}};
  if (target != GlbTarget::None) view["target"] = static_cast<int>(target);
  json["bufferViews"].push_back(std::move(view));
  pieces_.push_back({bytes, std::move(write)});
  bytes_ += aligned(bytes);
  return json["bufferViews"].size() - 1;
}

std::size_t GlbFile::add_accessor(std::size_t view, GlbComponent component, std::size_t count,
                                  const char* type, const Json& limits) {
  Json accessor = {{"bufferView", view},
                   {"componentType", static_cast<int>(component)},
                   {"count", count},
                   {"type", type}};
  if (!limits.is_null()) accessor.update(limits);
  json["accessors"].push_back(std::move(accessor));
  return json["accessors"].size() - 1;
}

void GlbFile::write(std::ostream& out) {
  if (bytes_ > 0) json["buffers"] = {{{"byteLength", bytes_}}};
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize(aligned(text.size()), ' ');
  std::size_t total = kHeaderBytes + kChunkHeaderBytes + text.size();
  if (bytes_ > 0) total += kChunkHeaderBytes + bytes_;
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Status::Input, "the mesh is larger than the 4 GiB of a GLB file", {},
                "a coarser tolerance gives fewer triangles");
  }
  ByteWriter writer(out);
  const auto put = [&](std::size_t number) { writer.put(static_cast<std::uint32_t>(number)); };
  for (const std::size_t number : {std::size_t{kMagic}, std::size_t{kGltfVersion}, total}) {
    put(number);
  }
  put(text.size());
  put(kJsonChunk);
  writer.put_text(text);
  if (bytes_ > 0) {
    put(bytes_);
    put(kByteChunk);
  }
  for (const Piece& piece : pieces_) {
    piece.write(writer);
    for (std::size_t i = piece.bytes; i < aligned(piece.bytes); ++i) writer.put('\0');
  }
  writer.flush();
}

nlohmann::ordered_json json_of_glb(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kText = kHeaderBytes + kChunkHeaderBytes;
  const bool is_glb = bytes.size() >= kText && number_at(bytes, 0) == kMagic &&
                      number_at(bytes, kHeaderBytes + 4) == kJsonChunk;
  if (!is_glb) throw Error(Status::Input, name + " is not a GLB file");
  const std::size_t length = number_at(bytes, kHeaderBytes);
  const std::string_view text = std::string_view(bytes).substr(kText, length);
  auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) throw Error(Status::Input, name + " is damaged");
  return json;
}

}  // namespace saddle
