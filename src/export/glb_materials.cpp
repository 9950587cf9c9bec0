#include "export/glb_materials.h"

#include <algorithm>
#include <cmath>

namespace saddle {
namespace {

using Json = GlbFile::Json;

constexpr const char* kUnlit = "KHR_materials_unlit";

/// From a colour as screens have it to the linear one of glTF. Source: IEC 61966-2-1, sRGB.
double linear(double channel) {
  const double c = std::clamp(channel, 0.0, 1.0);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Json linear_of(const Color& color) {
  return {linear(color.r), linear(color.g), linear(color.b)};
}

/// The roughness of a microfacet lobe as wide as Phong's. Source: B. Karis, "Specular BRDF
/// reference", 2013: alpha^2 = 2 / (n + 2), and glTF's alpha is the square of its roughness.
double roughness_of(double shininess) {
  return std::pow(2 / (shininess + 2), 0.25);
}

Json json_of(const GlbMaterial& look) {
  Json base = look.textured ? Json{1.0, 1.0, 1.0} : linear_of(look.material.diffuse);
  base.push_back(look.opacity);
  Json pbr = {{"baseColorFactor", base},
              {"metallicFactor", 0.0},
              {"roughnessFactor", look.unlit ? 1.0 : roughness_of(look.material.shininess)}};
  if (look.textured) pbr["baseColorTexture"] = {{"index", 0}, {"texCoord", 0}};
  Json json = {{"pbrMetallicRoughness", pbr}};
  const Json emission = linear_of(look.material.emission);
  if (emission != Json{0.0, 0.0, 0.0}) json["emissiveFactor"] = emission;
  if (look.opacity < 1) json["alphaMode"] = "BLEND";
  if (look.double_sided) json["doubleSided"] = true;
  if (look.unlit) json["extensions"] = {{kUnlit, Json::object()}};
  return json;
}

}  // namespace

std::size_t add_material(const GlbMaterial& look, GlbFile& file) {
  Json& materials = file.json["materials"];
  Json json = json_of(look);
  const auto known = std::find(materials.begin(), materials.end(), json);
  if (known != materials.end()) return static_cast<std::size_t>(known - materials.begin());
  materials.push_back(std::move(json));
  Json& used = file.json["extensionsUsed"];
  if (look.unlit && used.empty()) used.push_back(kUnlit);
  return materials.size() - 1;
}

GlbMaterial plain_look(const Color& color) {
  GlbMaterial look;
  look.material.diffuse = color;
  look.unlit = true;
  look.double_sided = true;
  return look;
}

}  // namespace saddle
