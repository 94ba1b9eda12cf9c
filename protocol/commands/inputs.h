// Properties that each command declares about itself, so that a tool is one struct. A command that lacks one does not
// compile.
#pragma once

namespace pelage {

/// Members in model coordinates that a command has, besides its stroke.
enum class Inputs {
  none,   // nothing to check, to mirror or to move to other models
  placed  // positions, directions or lengths: resolve.cpp checks and symmetry.cpp transforms them
};

/// How the work of a tool grows, besides that of its stroke.
enum class Work {
  vertices,            // with the vertices under its stroke, or with all if it has none
  vertices_x_samples,  // the same, and each vertex looks at all samples of the stroke
  own                  // counted in evaluation_cost.cpp
};

/// Whether the tool has an opposite, which Brush::invert selects.
enum class Opposite { no, yes };

/// A tool that does nothing without a stroke declares `static constexpr bool needs_stroke = true`.
template <class Tool>
concept NeedsStroke = requires {
  requires Tool::needs_stroke;
};

template <class Command>
concept Placed = Command::inputs == Inputs::placed;
template <class Command>
concept Unplaced = Command::inputs == Inputs::none;

}  // namespace pelage
