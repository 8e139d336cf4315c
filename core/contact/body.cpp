#include "core/contact/body.h"

#include "core/base/outward.h"

namespace trivet {

Body::Body(const Shape& s, const Affine& m) : shape(&s), world_from_object(m) {
  if (!s.has_faces()) return;
  const Aabb b = rounded_outwards(s.box);
  const Vec3 centre = m.apply(b.centre()), half = m.linear.cwiseAbs() * b.half_extent();
  const Vec3 margin = 1e-14 * (centre.cwiseAbs() + half);
  world_box = {centre - half - margin, centre + half + margin};
}

UnitFrame::UnitFrame(const Body& fixed)
    : unit_from_world((fixed.world_from_object.linear / fixed.scale()).transpose()),
      origin(fixed.world_from_object.translation) {}

PlacedBvh UnitFrame::tree(const Body& other) const {
  return {other.shape->bvh(), unit_from_world * other.world_from_object.linear,
          point(other.world_from_object.translation), other.scale()};
}

PlacedBvh UnitFrame::own_tree(const Body& fixed) const {
  const double scale = fixed.scale();
  PlacedBvh tree(fixed.shape->bvh(), scale * Mat3::Identity(), Vec3::Zero(), scale);
  tree.own_frame = true;
  return tree;
}

}  // namespace trivet
