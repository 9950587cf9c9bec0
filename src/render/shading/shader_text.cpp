#include "render/shading/shader_text.h"

#include <algorithm>
#include <cassert>
#include <sstream>

namespace saddle {

std::string keep_defined(const std::string& text, const std::vector<std::string>& names) {
  std::string result;
  std::istringstream lines(text);
  std::vector<bool> kept;  // of the conditions around a line
  for (std::string line; std::getline(lines, line);) {
    const bool if_defined = line.starts_with("#ifdef ");
    const bool if_not = line.starts_with("#ifndef ");
    if (if_defined || if_not) {
      const std::string name = line.substr(line.find(' ') + 1);
      kept.push_back((std::ranges::find(names, name) != names.end()) == if_defined);
    } else if (line == "#else") {
      kept.back() = !kept.back();
    } else if (line == "#endif") {
      kept.pop_back();
    } else if (std::ranges::find(kept, false) == kept.end()) {
      const bool second_empty = line.empty() && result.ends_with("\n\n");
      if (!second_empty) result += line + "\n";
    }
  }
  assert(kept.empty());
  return result;
}

}  // namespace saddle
