// Reference implementation of the brush, over all vertices.
#pragma once

#include <optional>

#include "tests/property/groom/reference/body.h"
#include "tests/property/groom/reference/standing.h"

namespace pelage::plain {

/// One dab: its centre, the direction in which the brush moved there (0 if it stood still), the arc length that it
/// stands for in radii of the first sample, its pressure, and its radius in sizes.
struct Print {
  dvec3 centre{0}, motion{0};
  double arc = 0, pressure = 1, radius = 0;
};

/// The dabs of a moving brush; with `begin` there is one more at the stroke's start.
std::vector<Print> prints_of(const Stroke& stroke, const Brush& brush, const Body& body, bool begin);

/// Weight of the dab at each vertex, [0, 1]: strength x falloff x pressure on front faces, without the mask. With
/// `standing`, distances are those of the strands, and the facing of a root counts less by twice the height at which
/// its strand is reached (in strand lengths).
std::vector<double> weights_of(const Print& print, const Stroke& stroke, const Brush& brush, const Body& body,
                               const std::optional<Standing>& standing);

/// The largest weight of any dab, or the brush's strength everywhere if there is no stroke; times the mask.
std::vector<double> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                              const Fur& fur, bool masked = true);

/// The same, but 1 instead of the brush's strength if there is no stroke: for tools with a strength of their own.
std::vector<double> restriction_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                                   const Fur& fur);

double falloff_at(const Brush& brush, double distance);

/// Share of a field's half of the strand (root or tip) that lies in the brush's part of the strand; 1 for other fields.
double strand_part(const Brush& brush, Field field);

/// Position of a sample, in internal coordinates.
dvec3 position_of(const StrokeSample& sample, const Body& body);

/// The point nearest to `position` on the straight lines between samples.
dvec3 nearest_of_path(const Stroke& stroke, const Body& body, dvec3 position);

}  // namespace pelage::plain
