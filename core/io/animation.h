// Scenes that move, as binary glTF with animated nodes.
#pragma once

#include <string>
#include <vector>

#include "core/model/exported_floats.h"

namespace trivet {

/// Where an object is at a time.
struct AnimationKey {
  double time = 0;         // seconds, ascending
  bool hidden = false;     // not there until the next key; the matrix means nothing
  Affine world_from_file;  // a rotation times the object's scale, and a translation
};

struct AnimatedObject {
  ExportObject object;             // its matrix is that of the first key that shows it
  std::vector<AnimationKey> keys;  // fewer than two: it stands still
};

struct AnimatedScene {
  std::vector<AnimatedObject> objects;
  Vec3 origin = Vec3::Zero();  // as ExportScene::origin
};

/// The bytes of a .glb with one animation: translation and rotation of each node, linear between
/// keys (the short way round), and a scale of 0 where it is hidden. float32: for the eye; only
/// write_scene() keeps what was proved.
/// @throws Error (BadInput) naming an object whose pose is beyond the range of float32.
std::string animated_glb(const AnimatedScene& scene);

}  // namespace trivet
