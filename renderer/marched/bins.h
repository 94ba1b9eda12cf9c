// The triangles of all shells by the tiles that they touch.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/marched/march_scene.h"

namespace pelage {

class Bins {
 public:
  /// Of the pieces of a scene whose vertices are placed. In each tile roughly from near to far: first what faces the
  /// camera, the outer shells first, then what faces away, the inner shells first. Only the tiles that the scene's box
  /// touches. What reaches behind the camera is cut, and its rows added to the scene's.
  explicit Bins(MarchScene& scene);

  int count() const { return across_ * down_; }
  Tile tile(int index) const;

 private:
  struct Box {
    std::int16_t left, right, top, bottom;  // tiles; none where right < left
    bool empty() const { return right < left; }
  };
  struct Entry {
    ShellTriangle triangle;
    Box box;
  };
  struct Entries {
    std::vector<Entry> near, far;  // that face the camera, and that do not
  };
  void clip(Box& box) const;
  Box box_of(const MarchScene& scene, const ShellTriangle& triangle) const;
  void add(MarchScene& scene, ShellTriangle triangle, Entries& entries) const;
  void fill(const Entries& entries);

  int left_ = 0, top_ = 0, across_ = 0, down_ = 0;  // tiles
  std::vector<std::uint32_t> first_;                // of each tile, in triangles_; one more at the end
  std::vector<ShellTriangle> triangles_;
};

}  // namespace pelage
