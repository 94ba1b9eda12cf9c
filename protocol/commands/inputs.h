// What a command says of itself, so that a tool is one struct: a command without a word on it does not compile.
#pragma once

namespace pelage {

/// What a command has in the model beside its stroke.
enum class Inputs {
  none,   // nothing: it is checked, mirrored and carried to other models as it stands
  placed  // positions, directions or lengths: resolve.cpp checks them, move_command.cpp moves them
};

/// How the work of a tool grows, beside that of its stroke.
enum class Work {
  vertices,            // with the vertices under its stroke, or all of them
  vertices_x_samples,  // each of them looks at the whole stroke
  own                  // evaluation_cost.cpp says it
};

/// Whether `invert` means anything.
enum class Opposite { no, yes };

/// A tool that does nothing without a stroke says `static constexpr bool needs_stroke = true`.
template <class Tool>
concept NeedsStroke = requires {
  requires Tool::needs_stroke;
};

template <class Command>
concept Placed = Command::inputs == Inputs::placed;
template <class Command>
concept Unplaced = Command::inputs == Inputs::none;

}  // namespace pelage
