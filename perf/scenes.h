// The demos as scenes for measuring PUT, optionally with refined models.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/files/layout/layout.h"
#include "tests/support/random_shapes.h"
#include "tests/support/settle_options.h"

namespace trivet::perf {

/// A demo before its first operation: fixed objects placed, the others unplaced.
struct DemoScene {
  Scene scene;
  std::vector<PutOperation> operations;
  std::int64_t num_triangles = 0;  // of all objects; shared models count repeatedly
};

/// @param splits  pieces per edge of every model: splits^2 triangles for one.
DemoScene make_demo_scene(const std::string& name, int splits = 1);

/// The smallest number of splits that gives at least `num_triangles`.
int splits_for(const DemoScene& demo, std::int64_t num_triangles);

/// The same surface with splits^2 coplanar triangles for each one (up to rounding); neighbours stay
/// welded.
Mesh refined(const Mesh& mesh, int splits);

/// A step of PUSH, metres, as of a mouse between two frames, and the eight directions that are
/// tried.
inline constexpr double kPushStep = 0.005;
extern const std::array<Vec2, 8> kPushDirections;

/// A start of the layout with a random orientation, and up to `jitter` metres aside.
Pose random_start(const Pose& start, double jitter, test::Random& random);

}  // namespace trivet::perf
