#include "ops/stability/stability.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/scene/joint.h"
#include "ops/stability/carried.h"
#include "ops/stability/certificate.h"
#include "ops/stability/part.h"
#include "ops/stability/verdict.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

// Free objects that contacts connect with these, in the scene's order.
std::vector<ObjectId> linked_with(const Scene& scene, std::vector<ObjectId> ids) {
  // Contacts are followed until no more objects come.
  std::set<std::uint32_t> seen;
  for (const ObjectId id : ids) seen.insert(id.index);
  for (size_t i = 0; i < ids.size(); ++i)
    for (const ObjectId member : one_body(scene, ids[i]))
      for (const ObjectContact& entry : scene.at(member).contacts) {
        if (entry.with.is_floor()) continue;
        const ObjectId with = root_of(scene, entry.with.object());
        if (!scene.at(with).fixed && seen.insert(with.index).second) ids.push_back(with);
      }
  scene.sort(ids);
  return ids;
}

// The same, by the contacts of the linear program, too, which are some clearances wide.
std::vector<ObjectId> judged_with(const Scene& scene, ObjectId object,
                                  const StabilityOptions& options) {
  std::vector<ObjectId> ids = linked_with(scene, {object});
  while (true) {
    // Each pass adds what lies within the tolerance, and everything that is linked with that.
    const FreeBodies near =
        near_part(scene, ids, checked_clearance(scene, options), is_fixed, {options.friction});
    if (near.bodies.size() == ids.size()) return ids;
    ids.clear();
    for (const FreeBody& body : near.bodies) ids.push_back(body.id);
    ids = linked_with(scene, std::move(ids));
  }
}

bool is_linked(const Object& object, const Support& with) {
  return std::any_of(object.contacts.begin(), object.contacts.end(),
                     [&](const ObjectContact& entry) { return entry.with == with; });
}

}  // namespace

const char* to_string(Stability::Status status) {
  switch (status) {
    case Stability::Status::Stable:
      return "stable";
    case Stability::Status::Marginal:
      return "marginal";
    case Stability::Status::Unstable:
      return "unstable";
    case Stability::Status::Unknown:
      return "unknown";
  }
  return "?";
}

const char* to_string(Stability::Method method) {
  return method == Stability::Method::Certificate ? "certificate" : "linear program";
}

Stability stability(const Scene& scene, const StabilityOptions& options) {
  return checked(scene, options, free_bodies(scene, {options.friction}));
}

Stability toppling(const Scene& scene, const StabilityOptions& options) {
  return checked(scene, options, free_bodies(scene, {options.friction}), Wanted::Findings);
}

Stability stability_of_part(const Scene& scene, ObjectId object, const StabilityOptions& options) {
  const Object& of = scene.at(object);
  std::vector<ObjectId> ids;
  if (of.placed && !of.fixed) ids = judged_with(scene, object, options);
  return checked(scene, options, linked_bodies(scene, ids, {options.friction}));
}

std::vector<CarriedBy> carried_by_part(const Scene& scene, ObjectId object,
                                       const StabilityOptions& options) {
  const Object& of = scene.at(object);
  if (!of.placed || of.fixed) return {};
  std::vector<ObjectId> ids = linked_with(scene, {object});
  if (ids.size() > kMostAskedForCarriers) return {};
  // Vertical forces through the links name all carriers: the usual case, which costs little.
  const auto is_certified = [](const Certificate::Body& body) { return body.certified; };
  const FreeBodies linked = linked_bodies(scene, ids, {options.friction});
  const Certificate certificate = vertical_certificate(linked);
  if (std::all_of(certificate.bodies.begin(), certificate.bodies.end(), is_certified)) return {};
  ids = judged_with(scene, object, options);
  if (ids.size() > kMostAskedForCarriers) return {};
  const Stability forces =
      checked(scene, options, linked_bodies(scene, ids, {options.friction}), Wanted::ForcesAlone);
  return carried_by_forces(scene, forces);
}

std::vector<CarriedBy> carried_by_forces(const Scene& scene, const Stability& stability) {
  std::vector<CarriedBy> out;
  if (!stability.stable()) return out;
  for (auto f = stability.forces.begin(); f != stability.forces.end();) {
    const ObjectId on = f->on;
    // The upward forces of each partner are added up, as one partner may touch at many points.
    std::vector<std::pair<Support, double>> upward;
    for (; f != stability.forces.end() && f->on == on; ++f) {
      auto at = std::find_if(upward.begin(), upward.end(),
                             [&](const auto& sum) { return sum.first == f->from; });
      if (at == upward.end()) at = upward.insert(at, {f->from, 0});
      at->second += f->force.z();
    }
    // Without a link nothing touches: such a force is one of several solutions.
    for (const auto& [from, force] : upward)
      if (force > kCarriedPart * weight_of(scene.at(on)) && is_linked(scene.at(on), from))
        out.push_back({on, from});
  }
  return out;
}

}  // namespace trivet
