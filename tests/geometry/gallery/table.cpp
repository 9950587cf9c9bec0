#include "geometry/gallery/table_parts.h"

namespace saddle {

std::span<const GalleryFacts> gallery_facts() {
  static const std::vector<GalleryFacts> facts = [] {
    std::vector<GalleryFacts> all;
    for (auto* part :
         {quadrics_and_revolutions, minimal_surfaces, pseudospherical_surfaces, one_sided_surfaces,
          singular_surfaces, tubes_and_shells, minimal_surfaces_of_complex_numbers,
          surfaces_of_the_three_sphere, functions_and_sums}) {
      for (GalleryFacts& entry : part()) all.push_back(std::move(entry));
    }
    return all;
  }();
  return facts;
}

}  // namespace saddle
