// saddle list: the gallery, a line each: names for scripts, with descriptions for people.
#include <algorithm>

#include "app/commands/commands.h"
#include "base/error.h"
#include "base/standard_streams.h"
#include "scene/model/gallery.h"

namespace saddle {

void run_list(const CommandLine& line) {
  const std::vector<std::string>& words = line.segments[0].arguments;
  if (!words.empty() || line.segments.size() > 1) {
    throw Error(Status::Input,
                "saddle list takes no arguments, not '" + (words.empty() ? "+" : words[0]) + "'",
                {}, "saddle show NAME prints a surface, saddle NAME -o FILE.png draws it");
  }
  const bool describe = line.run.verbose || standard_output_is_terminal();
  std::size_t width = 0;
  for (const GalleryEntry& entry : gallery()) width = std::max(width, entry.name.size());
  std::string text;
  for (const GalleryEntry& entry : gallery()) {
    text += entry.name;
    if (describe) text.append(width + 2 - entry.name.size(), ' ').append(entry.description);
    text += '\n';
  }
  print(text);
}

}  // namespace saddle
