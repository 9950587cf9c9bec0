// The only test source with absolute paths in it: the others compile alike in every folder, so a
// compiler cache serves all checkouts.
#include "paths.h"

namespace saddle {

std::string program_path() {
  return SADDLE_PROGRAM;
}

std::string source_folder() {
  return SADDLE_SOURCE_DIR;
}

}  // namespace saddle
