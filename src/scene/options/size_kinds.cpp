#include "scene/options/size_kinds.h"

#include "scene/model/values.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {
namespace {

std::string pair_text(int a, int b) {
  return std::to_string(a) + "x" + std::to_string(b);
}

}  // namespace

void PictureSize::parse(const Given& given) const {
  const GridSize size = parse_pair(given.option, given.text, 1, kMaxPixels);
  value->width = size.u;
  value->height = size.v;
}

std::string PictureSize::format() const {
  return pair_text(value->width, value->height);
}

void PictureSize::read(const InFile& in) const {
  const auto parse = [](const std::string& option, const std::string& text) {
    return parse_pair(option, text, 1, kMaxPixels);
  };
  const GridSize size = read_option(in, "two whole numbers, such as [800, 600]", parse);
  value->width = size.u;
  value->height = size.v;
}

std::string PictureSize::write() const {
  return toml_string(format());
}

void GridLines::parse(const Given& given) const {
  const GridSize lines = parse_grid_lines(given.option, given.text);
  surface->grid_u = lines.u;
  surface->grid_v = lines.v;
}

std::string GridLines::format() const {
  const bool off = surface->grid_u == 0 && surface->grid_v == 0;
  return off ? "off" : pair_text(surface->grid_u, surface->grid_v);
}

void GridLines::read(const InFile& in) const {
  const GridSize lines =
      read_option(in, "two whole numbers, [16, 16], or \"off\"", parse_grid_lines);
  surface->grid_u = lines.u;
  surface->grid_v = lines.v;
}

std::string GridLines::write() const {
  return "[" + std::to_string(surface->grid_u) + ", " + std::to_string(surface->grid_v) + "]";
}

void MemorySize::parse(const Given& given) const {
  *value = parse_memory(given.option, given.text);
}

std::string MemorySize::format() const {
  return format_number(*value) + "B";
}

void MemorySize::read(const InFile& in) const {
  *value = read_option(in, "bytes with a unit: \"2GB\"", parse_memory);
}

std::string MemorySize::write() const {
  return toml_string(format());
}

void Cells::parse(const Given& given) const {
  *value = parse_samples(given.option, given.text);
}

std::string Cells::format() const {
  return *value ? pair_text((*value)->u, (*value)->v) : "";
}

void Cells::read(const InFile& in) const {
  *value = read_option(in, "two whole numbers, such as [100, 50]", parse_samples);
}

std::string Cells::write() const {
  return *value ? toml_string(format()) : "";
}

void Length::parse(const Given& given) const {
  *value = parse_tolerance(given.option, given.text);
}

std::string Length::format() const {
  return *value ? format_number((*value)->value) + ((*value)->pixels ? "px" : "") : "";
}

void Length::read(const InFile& in) const {
  *value = read_option(in, "a length: \"0.5px\", or 1e-3", parse_tolerance);
}

std::string Length::write() const {
  return *value && (*value)->pixels ? toml_string(format()) : format();
}

void ClipBox::parse(const Given& given) const {
  *value = parse_clip(given.option, given.text);
}

std::string ClipBox::format() const {
  if (!value->box) return value->automatic ? "" : "off";
  std::string ranges;
  for (int k = 0; k < 3; ++k) {
    ranges += (k == 0 ? "" : ",") + format_number(value->box->low[k]) + ":" +
              format_number(value->box->high[k]);
  }
  return ranges;
}

void ClipBox::read(const InFile& in) const {
  const std::string text =
      in.reader.text(in.subject, in.value, "\"auto\", \"off\" or \"-1:1,-1:1,0:5\"");
  *value = in.reader.in_place([&] { return parse_clip(in.subject, text); });
}

std::string ClipBox::write() const {
  const std::string text = format();
  return text.empty() ? "" : toml_string(text);
}

}  // namespace saddle::kinds
