#include "server/calibration/ladder.h"

namespace pelage {

namespace {

struct Row {
  FragmentOrder order;
  int shells, steps;
  double scale;
};

// Shells times steps that divide the slices of the coat, or are a multiple of them, are nearest for their price; the
// others stand where no such ones are.
constexpr auto shells = FragmentOrder::shells, sorted = FragmentOrder::sorted;
constexpr Row rows[] = {{shells, 4, 4, .25}, {shells, 4, 4, .35}, {shells, 4, 4, .5},  {shells, 4, 8, .5},
                        {shells, 8, 4, .5},  {shells, 4, 8, .6},  {shells, 8, 4, .6},  {shells, 4, 8, .75},
                        {shells, 8, 4, .75}, {shells, 8, 4, .87}, {shells, 4, 8, 1},   {shells, 8, 4, 1},
                        {shells, 12, 3, 1},  {shells, 16, 4, 1},  {shells, 24, 3, 1},  {shells, 32, 2, 1},
                        {shells, 64, 1, 1},  {sorted, 8, 4, .6},  {sorted, 8, 4, .75}, {sorted, 8, 4, .87},
                        {sorted, 8, 4, 1},   {sorted, 12, 3, 1},  {sorted, 16, 2, 1},  {sorted, 18, 4, 1},
                        {sorted, 24, 3, 1},  {sorted, 24, 5, 1},  {sorted, 32, 2, 1},  {sorted, 32, 4, 1},
                        {sorted, 64, 2, 1},  {sorted, 64, 3, 1},  {sorted, 96, 2, 1}};

}  // namespace

std::vector<Knobs> candidate_ladder() {
  std::vector<Knobs> ladder{knobs_of(Tier::interactive)};
  for (const Row& row : rows) {
    Knobs knobs = knobs_of(Tier::interactive);
    knobs.shells = row.shells, knobs.steps = row.steps, knobs.scale = row.scale;
    knobs.shell_policy = ShellPolicy::uniform, knobs.order = row.order;
    ladder.push_back(knobs);
  }
  return ladder;
}

}  // namespace pelage
