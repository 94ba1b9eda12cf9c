// The brush again, over all vertices.
#pragma once

#include <optional>

#include "tests/property/groom/reference/body.h"
#include "tests/property/groom/reference/standing.h"

namespace pelage::plain {

/// One dab: where, which way the brush came (0 where it stood), the arc length it stands for in radii of the first
/// sample, and its pressure and radius (sizes).
struct Print {
  dvec3 centre{0}, motion{0};
  double arc = 0, pressure = 1, radius = 0;
};

/// The dabs of a brush that moves; with `begin` there is one more where the stroke begins.
std::vector<Print> prints_of(const Stroke& stroke, const Brush& brush, const Body& body, bool begin);

/// What the dab does to each vertex, [0, 1]: strength x falloff x pressure on front faces, without the mask. Of fur
/// that stands the strands are reached, and a root's facing counts less by twice the height, in lengths, at which the
/// strand is reached.
std::vector<double> weights_of(const Print& print, const Stroke& stroke, const Brush& brush, const Body& body,
                               const std::optional<Standing>& standing);

/// The largest weight of any dab, or the brush's strength everywhere without a stroke; times the mask.
std::vector<double> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                              const Fur& fur, bool masked = true);

/// The same without a strength of its own where there is no stroke: tools that bring their own.
std::vector<double> restriction_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                                   const Fur& fur);

double falloff_at(const Brush& brush, double distance);

/// The share of a field's half of the strand (root or tip) that the brush's part of the strand holds; 1 for other
/// fields.
double strand_part(const Brush& brush, Field field);

/// The place of a sample, internal coordinates.
dvec3 place_of(const StrokeSample& sample, const Body& body);

/// The nearest point of the straight lines between samples.
dvec3 nearest_of_path(const Stroke& stroke, const Body& body, dvec3 place);

}  // namespace pelage::plain
