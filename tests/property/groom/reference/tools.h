// One function for each tool, which changes the fur in place, perhaps beyond its ranges.
#pragma once

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

void apply(const Comb& command, const Stage& stage, Fur& fur);
void apply(const Blow& command, const Stage& stage, Fur& fur);
void apply(const Attract& command, const Stage& stage, Fur& fur);
void apply(const Part& command, const Stage& stage, Fur& fur);
void apply(const Whorl& command, const Stage& stage, Fur& fur);
void apply(const Lift& command, const Stage& stage, Fur& fur);
void apply(const Clump& command, const Stage& stage, Fur& fur);
void apply(const Curl& command, const Stage& stage, Fur& fur);

void apply(const Interpolate& command, const Stage& stage, Fur& fur);
void apply(const Flow& command, const Stage& stage, Fur& fur);
void apply(const Smooth& command, const Stage& stage, Fur& fur);

void apply(const Noise& command, const Stage& stage, Fur& fur);
void apply(const Unify& command, const Stage& stage, Fur& fur);
void apply(const Length& command, const Stage& stage, Fur& fur);
void apply(const Trim& command, const Stage& stage, Fur& fur);
void apply(const Erase& command, const Stage& stage, Fur& fur);
void apply(const Paint& command, const Stage& stage, Fur& fur);

void apply(const ChangeMask& command, const Stage& stage, Fur& fur);

}  // namespace pelage::plain
