#include "core/index/shape.h"

#include <tbb/task_arena.h>

#include <atomic>

#include "core/index/shape_index.h"

namespace trivet {
namespace {

// Embree waits for tasks of its own; another task taken up meanwhile might need the same tree.
Bvh build_isolated(const Mesh& mesh) {
  Bvh out;
  tbb::this_task_arena::isolate([&] { out = build_bvh(mesh); });
  return out;
}

}  // namespace

Shape::Shape() : index(std::make_shared<ShapeIndex>()) {}

const Bvh& Shape::bvh() const {
  return index->bvh.get([this] { return build_isolated(mesh); });
}

bool Shape::has_bvh() const { return index->bvh.is_made(); }

std::shared_ptr<const Shape> make_shape(Mesh mesh) {
  static std::atomic<std::uint64_t> next_id = 1;
  auto shape = std::make_shared<Shape>();
  shape->id = next_id++;
  shape->mesh = std::move(mesh);
  shape->box = shape->mesh.box();
  shape->adjacency = make_adjacency(shape->mesh);
  shape->mass = mass_properties(shape->mesh, shape->adjacency);
  return shape;
}

}  // namespace trivet
