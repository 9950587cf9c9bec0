// Errors about a scene in the words of the command line that it comes from.
#pragma once

#include "app/command_line/cli.h"
#include "base/error.h"

namespace saddle {

/// The error with the name of the option in place of the key that the option sets, and with the
/// definition that would give an unknown name a value. Errors in files stay as they are.
Error as_typed(const Error& error, const CommandLine& line);

}  // namespace saddle
