// Distances over a body, by plain loops until nothing changes.
#pragma once

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// Distance and vector of each vertex from one key or one curve; infinite if it cannot be reached.
struct Reach {
  std::vector<double> distance;
  std::vector<dvec3> vector;
};

/// A vertex near a key, with its distance from the key and the key's vector in its tangent plane.
struct Corner {
  Vertex vertex = 0;
  double distance = 0;
  dvec3 vector{0};
};

/// Corners of all triangles that contain the point: of several triangles on an edge, one vertex alone if the point is a
/// vertex.
std::set<Vertex> corners_of(const Body& body, const SurfacePoint& point);

/// Shortest paths along edges (Bellman and Ford); the vector is transported from vertex to vertex.
Reach reach_along_edges(const Body& body, const std::vector<Corner>& corners);
/// Straight distances from the nearest corner; the vector is transported in one rotation.
Reach reach_through_space(const Body& body, const std::vector<Corner>& corners);

/// Fast marching with unfolded triangles (Novotni and Klein 2002), which searches all vertices for the next one. It
/// marches one ring beyond the radius, and back from there.
std::vector<double> marched_distances(const Body& body, const SurfacePoint& centre, double radius);

/// Normalized Gaussian weights of the distances; all 0 if every distance is infinite. The square of the smallest
/// distance is subtracted from each square, against underflow (science.md 3).
std::vector<double> gaussians(const std::vector<double>& distances, double sigma);

}  // namespace pelage::plain
