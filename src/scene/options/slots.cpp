#include "scene/options/slots.h"

#include <concepts>
#include <type_traits>

namespace saddle {

void parse_slot(const kinds::Slot& slot, const kinds::Given& given) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.parse(given); }) kind.parse(given);
      },
      slot);
}

bool clear_slot(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires {
                        { kind.clear() } -> std::same_as<bool>;
                      }) {
          return kind.clear();
        } else if constexpr (requires { kind.clear(); }) {
          kind.clear();
          return true;
        } else {
          return false;
        }
      },
      slot);
}

std::string format_slot(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.format(); }) return kind.format();
        return std::string();
      },
      slot);
}

std::vector<std::string> texts_of(const kinds::Slot& slot) {
  const auto texts = std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.texts(); }) return kind.texts();
        return std::vector<std::string>();
      },
      slot);
  const std::string text = format_slot(slot);
  return text.empty() ? texts : std::vector{text};
}

void read_slot(const kinds::Slot& slot, const kinds::InFile& in) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.read(in); }) kind.read(in);
      },
      slot);
}

std::string write_slot(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.write(); }) return kind.write();
        return std::string();
      },
      slot);
}

std::string write_beside(const kinds::Slot& slot, const kinds::Slot& standard) {
  return std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (requires { kind.write_beside(kind); }) {
          return kind.write_beside(std::get<Kind>(standard));
        }
        std::string text = write_slot(slot);
        return text == write_slot(standard) ? std::string() : text;
      },
      slot);
}

void resolve_slot(const kinds::Slot& slot, Resolver& resolver, const std::string& name) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.resolve(resolver, name); }) kind.resolve(resolver, name);
      },
      slot);
}

}  // namespace saddle
