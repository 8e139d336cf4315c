// Snapping: the corner, edge or place of a face of an object that the pointer means, and grids.
#pragma once

#include <optional>
#include <vector>

#include "apps/edit/document/snapshot.h"
#include "apps/edit/tools/view.h"

namespace trivet::edit {

/// Targets of snapping; see snap(). Metres.
struct SnapOptions {
  bool on = false;  // while a drag is on, Control turns it over
  bool corners = true, edges = true, faces = true, grid = true;
  double grid_step = 0.05;

  friend bool operator==(const SnapOptions&, const SnapOptions&) = default;
};

struct Snap {
  enum class Kind { Corner, Edge, Face };
  Kind kind = Kind::Face;
  Vec3 point = Vec3::Zero();       // world
  std::optional<ObjectId> object;  // nullopt: the floor

  friend bool operator==(const Snap&, const Snap&) = default;
};

/// Within this distance of the pointer, pixels.
inline constexpr double kSnapPx = 10;

/// Target of the pointer: the nearest visible corner within kSnapPx pixels, else the nearest
/// visible place of an edge, else the face under the pointer. Edges are those at which the faces
/// turn by more than 20 degrees, or that have not two faces; corners end at least one of them.
/// Distances are those of the picture; of two alike the first one counts, in the order of the
/// scene. Found in the objects' BVHs; the same as by looking at all edges, but where the 64 nearest
/// corners, or edges, are all hidden.
/// @param except  objects to ignore. @param only  if set, the other objects only hide.
std::optional<Snap> snap(const SceneSnapshot& scene, const View& view, const Vec2& px,
                         const SnapOptions& options, const std::vector<ObjectId>& except,
                         std::optional<ObjectId> only = {});

/// The multiple of `step` nearest to `value`; `value` itself where the step is none.
double on_grid(double value, double step);

/// "corner of \"shelf\"", "the floor", "grid 50 mm": in the language of the windows.
std::string in_words(const Snap& snap, const SceneSnapshot& scene);
std::string grid_in_words(double step);

}  // namespace trivet::edit
