#include "protocol/commands/command.h"

#include <type_traits>

namespace pelage {

namespace {

template <class C>
constexpr bool has_stroke = requires(C command) {
  command.stroke;
};

}  // namespace

Command::Command() = default;
Command::Command(const Command&) = default;
Command::Command(Command&&) noexcept = default;
Command& Command::operator=(const Command&) = default;
Command& Command::operator=(Command&&) noexcept = default;
Command::~Command() = default;

const char* op_of(const Command& command) {
  return std::visit([](const auto& c) { return c.op; }, command);
}

Stroke* stroke_of(Command& command) {
  return std::visit(
      [](auto& c) -> Stroke* {
        if constexpr (has_stroke<std::remove_reference_t<decltype(c)>>)
          return c.stroke ? &*c.stroke : nullptr;
        else
          return nullptr;
      },
      command);
}

const Stroke* stroke_of(const Command& command) { return stroke_of(const_cast<Command&>(command)); }

std::string edit_layer_of(const Command& command) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.edit_layer; })
          return c.edit_layer;
        else
          return std::string();
      },
      command);
}

std::vector<std::string> coats_of(const Command& command) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.edit_layer; })
          return c.coats;
        else
          return std::vector<std::string>();
      },
      command);
}

}  // namespace pelage
