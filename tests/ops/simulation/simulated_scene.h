// Scenes for simulation, laid out by Trivet.
#pragma once

#include <string>

#include "core/convex/parts.h"
#include "core/scene/scene.h"

namespace trivet::test {

/// A released object and the start pose of its PUT.
struct LetGo {
  std::string name;
  Pose pose;
};

struct LaidOut {
  Scene scene;  // at rest, contacts up to date
  std::vector<LetGo> starts;
};

/// A fixed table of boxes; on it and on the floor boxes, books and plates, each the convex hull of
/// its model, stacked and leaning: 14 free objects, put down by Trivet.
LaidOut convex_objects();

/// A box without lid, of walls with both sides.
Model open_box(double half, double height, double wall);

/// The convex hull of a model as a model.
Model hull_model(const Model& model);

}  // namespace trivet::test
