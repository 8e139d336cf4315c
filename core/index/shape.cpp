#include "core/index/shape.h"

#include <atomic>

#include "core/index/face_tree.h"
#include "core/index/shape_index.h"

namespace trivet {
Shape::Shape() : index(std::make_shared<ShapeIndex>()) {}

const Bvh& Shape::bvh() const {
  const auto build = [this] { return build_bvh(mesh); };
  const bool by_several = mesh.triangles.size() > kManyFaces;  // else threads need not be started
  return index->bvh.get([&] { return by_several ? isolated(build) : build(); });
}

bool Shape::has_bvh() const { return index->bvh.is_made(); }

namespace {

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> next = 1;
  return next++;
}

}  // namespace

std::shared_ptr<const Shape> with_mass(const Shape& shape, const MassProperties& mass) {
  auto out = std::make_shared<Shape>(shape);
  out->id = next_id();
  out->mass = mass;
  return out;
}

std::shared_ptr<const Shape> make_shape(Mesh mesh) {
  auto shape = std::make_shared<Shape>();
  shape->id = next_id();
  shape->mesh = std::move(mesh);
  shape->box = shape->mesh.box();
  shape->adjacency = make_adjacency(shape->mesh);
  shape->mass = mass_properties(shape->mesh, shape->adjacency);
  return shape;
}

}  // namespace trivet
