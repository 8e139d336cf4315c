#include <algorithm>

#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

constexpr double kSameWay = 1e-9;  // metres: as far as another pin

Refusal cannot(const Scene& scene, ObjectId draped, Sentence why) {
  Refusal out{Refusal::Cause::NoSheet, {named(scene, Support(draped))}};
  out.detail = std::move(why);
  return out;
}

DrapeOperation first_operation(const Object& object) {
  const Flexible& flexible = *object.flexible;
  DrapeOperation out;
  out.object = object.name;
  if (flexible.grid) out.size = Vec2(flexible.grid->length_u, flexible.grid->length_v);
  out.path = flexible.start->path;
  out.start = flexible.start->pose;
  out.cell = flexible.start->cell;
  out.pins = flexible.start->pins;
  out.material = flexible.material.name;
  out.thickness = flexible.material.thickness;
  out.density = flexible.material.density;
  out.bending = flexible.material.bending;
  out.friction = flexible.material.friction;
  return out;
}

/// Ways from where its pins are to where their holders are now: zero of those that nobody holds.
struct Carried {
  std::vector<Vec3> of_pins;
  std::vector<std::string> held_by;
};

std::variant<Carried, Refusal> carried(const Scene& scene, const Object& object) {
  const Flexible& flexible = *object.flexible;
  const Affine world = object.world_from_object();
  DrapeOperation first = first_operation(object);
  Carried out;
  out.of_pins.assign(first.pins.size(), Vec3::Zero());
  out.held_by.assign(flexible.ties.empty() ? 0 : first.pins.size(), "");
  for (size_t i = 0; i < flexible.ties.size() && i < first.pins.size(); ++i) {
    const FlexTie& tie = flexible.ties[i];
    const auto holder = scene.find(tie.name);
    if (!holder) return unknown_object(scene, tie.name);
    if (!scene.at(*holder).placed)
      return Refusal{Refusal::Cause::NotPlaced, {named(scene, Support(*holder))}};
    out.held_by[i] = tie.name;
    out.of_pins[i] = pin_at(scene.at(*holder), tie) - world.apply(flexible.vertices[tie.vertex]);
  }
  return out;
}

// The way of the pin at this corner, or of none.
Vec3 way_at(const DrapeOperation& o, const Carried& by, const Vec3& corner) {
  for (size_t i = 0; i < o.pins.size(); ++i)
    if ((o.pins[i] - corner).norm() < kSameWay) return by.of_pins[i];
  return Vec3::Zero();
}

// Corners between the ends go along with both, by their places on the way.
void carry_path(const Carried& by, DrapeOperation& o) {
  const Vec3 first = way_at(o, by, o.path.front()), last = way_at(o, by, o.path.back());
  const double length = length_of(o.path);
  double at = 0;
  std::vector<Vec3> out;
  for (size_t i = 0; i < o.path.size(); ++i) {
    if (i > 0) at += (o.path[i] - o.path[i - 1]).norm();
    const double share = i + 1 == o.path.size() ? 1 : at / length;
    out.emplace_back(o.path[i] + (1 - share) * first + share * last);
  }
  o.path = std::move(out);
}

bool all_are(const Vec3& wanted, const std::vector<Vec3>& ways) {
  return std::all_of(ways.begin(), ways.end(),
                     [&](const Vec3& way) { return (way - wanted).norm() < kSameWay; });
}

std::optional<Refusal> carry(const Scene& scene, ObjectId draped, const Carried& by,
                             DrapeOperation& o) {
  const Flexible& flexible = *scene.at(draped).flexible;
  if (flexible.is_cable) {
    carry_path(by, o);
    const double chord = (o.path.back() - o.path.front()).norm();
    if (o.pins.size() > 1 && chord > flexible.length)
      return Refusal{Refusal::Cause::Overstretched,
                     {named(scene, Support(draped))},
                     {{"stretch", chord / flexible.length}, {"largest_stretch", 1}}};
  } else if (!by.of_pins.empty()) {
    const Vec3 way = flexible.grid ? by.of_pins[0] : Vec3(Vec3::Zero());
    if (!all_are(way, by.of_pins))
      return cannot(scene, draped, "its pins have not all moved alike");
    o.start.translation += way;
  }
  for (size_t i = 0; i < o.pins.size(); ++i) o.pins[i] += by.of_pins[i];
  return std::nullopt;
}

flex::DrapeProblem problem_of(const Flexible& flexible, const DrapeOperation& o) {
  flex::DrapeProblem out;
  out.material = flexible.material;
  if (flexible.is_cable) {
    out.num_segments = static_cast<int>(flexible.faces.size());
    out.length = flexible.length;
    out.start = resampled(cable_path_of_length(o.path, out.length), out.num_segments);
  } else if (flexible.grid) {
    place_sheet(o, out);
  } else {
    out.faces = flexible.faces;
    out.start = flexible.rest;
  }
  pin(o, out);
  return out;
}

}  // namespace

Vec3 pin_at(const Object& holder, const FlexTie& tie) {
  return holder.pose.rotation.matrix() * tie.point + holder.pose.translation;
}

std::variant<DrapedAgain, Refusal> problem_again(const Scene& scene, ObjectId draped) {
  const Object& object = scene.at(draped);
  if (!object.flexible) return cannot(scene, draped, "it is not flexible");
  const Flexible& flexible = *object.flexible;
  if (!flexible.start) return cannot(scene, draped, "the file does not say how it began");
  auto by = carried(scene, object);
  if (auto* const why = std::get_if<Refusal>(&by)) return *why;
  DrapedAgain out{first_operation(object), {}};
  out.operation.held_by = std::get<Carried>(by).held_by;
  if (auto why = carry(scene, draped, std::get<Carried>(by), out.operation)) return *why;
  out.problem = problem_of(flexible, out.operation);
  return out;
}

}  // namespace trivet
