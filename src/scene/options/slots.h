// The value of an option or key, whatever its kind. A kind without one of these functions
// leaves the value alone: an option without a key, a key without an option.
#pragma once

#include <string>
#include <vector>

#include "scene/options/option_kinds.h"

namespace saddle {

/// Sets it to what the command line says. Throws Error (Input).
void parse_slot(const kinds::Slot& slot, const kinds::Given& given);

/// Back to a default that has no text; false: it has one.
bool clear_slot(const kinds::Slot& slot);

/// As on the command line; empty: there is nothing to say.
std::string format_slot(const kinds::Slot& slot);

/// The texts that set it, one after the other.
std::vector<std::string> texts_of(const kinds::Slot& slot);

/// Sets it to what a scene file says. Throws Error (Input).
void read_slot(const kinds::Slot& slot, const kinds::InFile& in);

/// As in a scene file; empty: there is nothing to say.
std::string write_slot(const kinds::Slot& slot);

/// The value of a row where it differs from another value of that row; empty: it does not.
std::string write_beside(const kinds::Slot& slot, const kinds::Slot& standard);

/// From expressions to numbers; `name` is what messages call it. Throws Error (Input).
void resolve_slot(const kinds::Slot& slot, Resolver& resolver, const std::string& name);

}  // namespace saddle
