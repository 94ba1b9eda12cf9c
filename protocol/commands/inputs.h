// Properties that each command declares of itself, so that a tool is one struct: a command that leaves one out does not
// compile.
#pragma once

namespace pelage {

/// What a command has in model coordinates, beside its stroke.
enum class Inputs {
  none,   // nothing: it is checked, mirrored and moved to other models without a change
  placed  // positions, directions or lengths: resolve.cpp checks them, symmetry.cpp moves them
};

/// What the work of a tool grows with, beside that of its stroke.
enum class Work {
  vertices,            // with the vertices under its stroke, or all of them
  vertices_x_samples,  // each of them looks at the whole stroke
  own                  // counted in evaluation_cost.cpp
};

/// Whether the tool has an opposite, which `invert` asks for.
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
