// Makes random tools and random fur, for properties that hold for all of them.
#pragma once

#include "base/random.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage::testing_commands {

/// Number of tools to test. The first commands of `Command` are the tools; the last two of them, map and retarget, need
/// more than a surface.
inline constexpr std::size_t tool_count = Tools::count - 2;

/// Returns the tool with this index in `Command`, with its defaults.
Command empty_tool(std::size_t tool);

/// How far numbers go: `ordinary` ones lie well inside their ranges, `extreme` ones are often at an end.
enum class Numbers { ordinary, extreme };
/// How many strokes have a view, which pixel radii and the screen shape need.
enum class Views { none, some };

class CommandMaker {
 public:
  CommandMaker(std::uint64_t seed, const Surface& surface, Numbers numbers, Views views = Views::some)
      : random_(seed), surface_(surface), numbers_(numbers), views_(views) {}

  /// Returns a random tool, or the one with this index in `Command`.
  Command command() { return command(below(tool_count)); }
  Command command(std::size_t tool);
  /// Returns fur in which every field, including the mask, has been changed at some vertices.
  FieldSet fields();
  Coat coat();

 private:
  double extreme(std::vector<double> special, double low, double high);
  std::size_t below(std::size_t count);
  bool chance(double share) { return random_.uniform() < share; }
  template <class Choice, std::size_t count>
  Choice one_of(const Choice (&all)[count]) {
    return all[below(count)];
  }

  glm::dvec3 cube();
  glm::dvec3 point();  // model coordinates, mostly near the surface
  glm::dvec3 heading();
  /// Converts a length in model sizes to the units.
  double in_units(double sizes, Units units) const;
  Units units() { return chance(0.5) ? Units::relative : Units::world; }
  View view();
  Brush brush();
  Stroke stroke();
  std::vector<Field> some_fields();
  /// Returns a tool with a brush, and a stroke or a flood.
  template <class Tool>
  Tool brushed();
  template <class Tool>
  Tool restricted();

  void make(Comb& comb);
  void make(Blow& blow);
  void make(Attract& attract);
  void make(Interpolate& interpolate);
  void make(Flow& flow);
  void make(Smooth& smooth);
  void make(Noise& noise);
  void make(Unify& unify);
  void make(Part& part);
  void make(Whorl& whorl);
  void make(Length& length);
  void make(Trim& trim);
  void make(Lift& lift);
  void make(Erase& erase);
  void make(Clump& clump);
  void make(Curl& curl);
  void make(Paint& paint);
  void make(ChangeMask& mask);
  Key key(Units units);

  Random random_;
  const Surface& surface_;
  Numbers numbers_;
  Views views_;
};

/// Sets the strength of the brush and the tool's own strength to 0.
void weaken(Command& command);

}  // namespace pelage::testing_commands
