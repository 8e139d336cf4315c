// Objects that are judged by another mesh than the one that is drawn.
#pragma once

namespace trivet {

struct Object;

/// True if the mesh of the object's shape is not that of its model, which is drawn. O(mesh).
bool has_collision_mesh(const Object& object);

}  // namespace trivet
