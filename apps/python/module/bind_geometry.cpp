// First contact and interpenetration of shapes, without a scene.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/python_shape.h"
#include "core/base/bad_input.h"
#include "core/base/tunables.h"
#include "core/contact/first_contact.h"
#include "core/exact/interpenetration.h"

namespace trivet::python {
namespace {

using namespace py::literals;

Body body_of(const PythonShape& shape, const Similarity& place) {
  return Body(*shape.shape, world_from_object(place.pose, UpAxis::Z, place.scale));
}

// As the clearance of a scene of these two.
double usual_clearance(const Body& a, const Body& b) {
  Aabb box = a.world_box;
  box.extend(b.world_box);
  const double size = std::max(box.diagonal(), box.max_abs_coordinate());
  const double larger = std::max(a.world_box.diagonal(), b.world_box.diagonal());
  return kRelativeClearance * std::min(size, std::max(kClearanceReach, kCoarseDiagonals * larger));
}

py::dict first_contact_dict(const FirstContact& contact, double amount) {
  return py::dict("crossing"_a = contact.status == FirstContact::Status::Crossing,
                  "amount"_a = amount, "point"_a = array_of(contact.point),
                  "normal"_a = array_of(contact.normal), "gap"_a = contact.gap,
                  "faces"_a = std::pair(contact.face_moving, contact.face_fixed));
}

// A quarter turn at a time, as motions are.
py::object turn(const PythonShape& moving, Similarity place, const Body& fixed, Vec3 axis,
                const Vec3& centre, double degrees, double clearance) {
  if (degrees < 0) axis = -axis;
  double done = 0;
  for (double left = std::abs(degrees); left > 0; left -= 90) {
    const double step = std::min(left, 90.0);
    const Body body = body_of(moving, place);
    FirstContactQuery query;
    query.moving = {&body, 1};
    query.fixed = {&fixed, 1};
    query.motion = Motion::rotation(centre, axis, turn_time(step));
    query.clearance.distance = clearance;
    const FirstContact contact = without_gil([&] { return first_contact(query); });
    if (contact.status != FirstContact::Status::Free)
      return first_contact_dict(contact, done + (contact.time > 0 ? turned_deg(contact.time) : 0));
    place.pose = moved_pose(place.pose, query.motion, query.motion.limit);
    done += step;
  }
  return py::none();
}

py::object slide(const PythonShape& moving, const Similarity& place, const Body& fixed,
                 const Vec3& direction, double distance, double clearance) {
  const Body body = body_of(moving, place);
  FirstContactQuery query;
  query.moving = {&body, 1};
  query.fixed = {&fixed, 1};
  query.motion = Motion::translation(direction, distance);
  query.clearance.distance = clearance;
  const FirstContact contact = without_gil([&] { return first_contact(query); });
  if (contact.status == FirstContact::Status::Free) return py::none();
  return first_contact_dict(contact,
                            contact.status == FirstContact::Status::Contact ? contact.time : 0);
}

/// @param centre  of a turn by `amount` degrees; none: a translation by `amount` metres.
py::object first(const PythonShape& moving, const Doubles& moving_pose, const PythonShape& fixed,
                 const Doubles& fixed_pose, const Doubles& axis,
                 const std::optional<Doubles>& centre, double amount, double clearance) {
  const Similarity place = similarity_of(moving_pose, "moving_pose");
  const Body body = body_of(fixed, similarity_of(fixed_pose, "fixed_pose"));
  const Vec3 along = vector_of(axis, "axis or direction");
  if (!(along.norm() > 0)) bad_input("axis or direction: of length 0; accepted: any other");
  if (!(clearance > 0)) clearance = usual_clearance(body_of(moving, place), body);
  if (!centre) return slide(moving, place, body, along.normalized(), amount, clearance);
  return turn(moving, place, body, along.normalized(), vector_of(*centre, "centre"), amount,
              clearance);
}

struct Placed {
  std::shared_ptr<PythonShape> shape;
  Positions positions;
  Affine world_from_object;
  Aabb box;
  double slack = 0;

  PlacedShape view() const { return {shape->shape.get(), &positions, world_from_object, slack}; }
};

// Where a vertex is, and how far that is from where the pose has it.
Placed placed(const py::tuple& entry) {
  Placed out;
  out.shape = entry[0].cast<std::shared_ptr<PythonShape>>();
  const Similarity place = similarity_of(entry[1].cast<Doubles>(), "pose");
  out.world_from_object = world_from_object(place.pose, UpAxis::Z, place.scale);
  const Positions own = world_positions(*out.shape->shape, out.world_from_object);
  out.positions = own;
  if (!entry[2].is_none()) {
    out.positions = vectors_of(entry[2].cast<Doubles>(), "positions");
    if (out.positions.size() != own.size())
      bad_input("positions: %1 of a shape with %2 vertices; accepted: one for each",
                out.positions.size(), own.size());
  }
  for (size_t i = 0; i < own.size(); ++i) {
    if (!out.positions[i].allFinite()) bad_input("positions: row %1 is not finite", i);
    out.slack = std::max(out.slack, (out.positions[i] - own[i]).norm());
    out.box.extend(out.positions[i]);
  }
  return out;
}

py::list interpenetrations(const std::vector<py::tuple>& entries) {
  std::vector<Placed> objects;
  for (const py::tuple& entry : entries) objects.push_back(placed(entry));
  struct Finding {
    size_t a, b;
    std::int64_t crossings;
    int contained;
  };
  const auto found = without_gil([&] {
    std::vector<Finding> out;
    for (size_t i = 0; i < objects.size(); ++i)
      for (size_t j = i + 1; j < objects.size(); ++j) {
        if (!overlaps(objects[i].box, objects[j].box)) continue;
        const PlacedShape a = objects[i].view(), b = objects[j].view();
        Finding finding{i, j, count_crossings(a, b), 0};
        if (finding.crossings == 0)
          finding.contained = count_components_inside(a, b) + count_components_inside(b, a);
        if (finding.crossings > 0 || finding.contained > 0) out.push_back(finding);
      }
    return out;
  });
  py::list out;
  for (const Finding& one : found)
    out.append(py::make_tuple(one.a, one.b, one.crossings, one.contained));
  return out;
}

}  // namespace

void bind_geometry(py::module_& m) {
  m.def("first_contact", &first, "moving"_a, "moving_pose"_a, "fixed"_a, "fixed_pose"_a, "axis"_a,
        "centre"_a, "amount"_a, "clearance"_a);
  m.def("interpenetrations", &interpenetrations, "objects"_a);
}

}  // namespace trivet::python
