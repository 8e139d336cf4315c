#include "core/index/shape.h"

#include <atomic>

namespace trivet {

std::shared_ptr<const Shape> make_shape(Mesh mesh) {
  static std::atomic<std::uint64_t> next_id = 1;
  auto shape = std::make_shared<Shape>();
  shape->id = next_id++;
  shape->mesh = std::move(mesh);
  shape->box = shape->mesh.box();
  shape->adjacency = make_adjacency(shape->mesh);
  shape->mass = mass_properties(shape->mesh, shape->adjacency);
  shape->bvh = build_bvh(shape->mesh);
  return shape;
}

}  // namespace trivet
