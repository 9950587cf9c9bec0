#include "view/window/draw_lists.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <imgui.h>

#include "base/format.h"

namespace saddle {
namespace {

void add_boxes(const ImDrawList& list, std::vector<PixelRect>& boxes) {
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    ImVec2 low{clip.z, clip.w};
    ImVec2 high{clip.x, clip.y};
    for (unsigned i = 0; i < command.ElemCount; ++i) {
      const int corner = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
      const ImVec2& at = list.VtxBuffer[static_cast<int>(command.VtxOffset) + corner].pos;
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    const int x = static_cast<int>(std::floor(std::max(low.x, clip.x)));
    const int y = static_cast<int>(std::floor(std::max(low.y, clip.y)));
    const int right = static_cast<int>(std::ceil(std::min(high.x, clip.z)));
    const int bottom = static_cast<int>(std::ceil(std::min(high.y, clip.w)));
    if (x < right && y < bottom) boxes.push_back({x, y, right - x, bottom - y});
  }
}

/// All that its commands draw.
void append_bytes(const ImDrawList& list, std::string& bytes) {
  const auto append = [&bytes](const auto& all) {
    bytes.append(reinterpret_cast<const char*>(all.Data), all.size_in_bytes());
  };
  append(list.VtxBuffer);
  append(list.IdxBuffer);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    bytes += formatted("%p %u %g %g %g %g ", command.TextureId, command.ElemCount, clip.x, clip.y,
                       clip.z, clip.w);
  }
}

std::span<ImDrawList* const> lists_of(const ImDrawData& drawn) {
  return {drawn.CmdLists, static_cast<std::size_t>(drawn.CmdListsCount)};
}

}  // namespace

std::vector<PixelRect> boxes_of(const ImDrawData& drawn) {
  std::vector<PixelRect> boxes;
  for (const ImDrawList* const list : lists_of(drawn)) add_boxes(*list, boxes);
  return boxes;
}

std::string bytes_of(const ImDrawData& drawn) {
  std::string bytes;
  for (const ImDrawList* const list : lists_of(drawn)) append_bytes(*list, bytes);
  return bytes;
}

}  // namespace saddle
