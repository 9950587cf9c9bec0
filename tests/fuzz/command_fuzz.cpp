// Any lines as the words of a command line: a scene, or an Error that can be shown. No file is
// opened: words with a slash or a point, and "-", are left out.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "app/run/build_scene.h"
#include "base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> words = {"saddle"};
  for (std::string word; std::getline(text, word);) {
    const bool is_file = word == "-" || word.find_first_of(std::string("/.\0", 3)) != word.npos;
    if (!is_file) words.push_back(word);
  }
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  CommandLine line;
  try {
    parse_command_line(static_cast<int>(words.size()), argv.data(), line);
    build_scene(line);
  } catch (const Error& error) {
    format_error(error);
  }
  return 0;
}
