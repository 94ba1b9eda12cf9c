// Distances over a body, by loops that go on until nothing changes.
#pragma once

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// Distance and vector of each vertex from one key or one curve; infinite where no way leads.
struct Reach {
  std::vector<double> distance;
  std::vector<dvec3> vector;
};

/// A corner near a key: how far it is from it, and what the key's vector is in its tangent plane.
struct Corner {
  Vertex vertex = 0;
  double distance = 0;
  dvec3 vector{0};
};

/// Corners of all triangles that hold a place, of two or more on an edge; a vertex alone where the place is one.
std::set<Vertex> corners_of(const Body& body, const SurfacePoint& place);

/// Shortest ways along edges (Bellman and Ford); the vector is brought from vertex to vertex.
Reach reach_along_edges(const Body& body, const std::vector<Corner>& corners);
/// Through space from the nearest corner, the vector in one rotation.
Reach reach_through_space(const Body& body, const std::vector<Corner>& corners);

/// Fast marching with unfolded triangles (Novotni and Klein 2002), looking for the next vertex among all. It goes one
/// ring beyond the radius, and back from there.
std::vector<double> marched_distances(const Body& body, const SurfacePoint& centre, double radius);

/// Gaussians of the distances over their sum; all 0 where every distance is infinite. The nearest source's square is
/// taken off each (science.md 3).
std::vector<double> gaussians(const std::vector<double>& distances, double sigma);

}  // namespace pelage::plain
