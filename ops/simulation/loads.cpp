#include "ops/simulation/loads.h"

#include <algorithm>

namespace trivet {
namespace {

constexpr double kUpwards = 0.1;  // of a contact's normal: what carries is below

std::vector<const ObjectContact*> contacts_below(const Object& object) {
  std::vector<const ObjectContact*> out;
  for (const ObjectContact& entry : object.contacts)
    if (entry.contact.normal.z() > kUpwards) out.push_back(&entry);
  return out;
}

}  // namespace

double heaviest_load(const Scene& scene, const std::map<ObjectId, size_t, SlotOrder>& body_of,
                     const std::vector<SimulationBody>& bodies) {
  std::vector<ObjectId> from_top;
  for (const auto& [id, body] : body_of)
    if (!bodies[body].fixed) from_top.push_back(id);
  std::stable_sort(from_top.begin(), from_top.end(), [&](ObjectId a, ObjectId b) {
    return scene.at(a).centre_of_mass().z() > scene.at(b).centre_of_mass().z();
  });
  std::map<ObjectId, double, SlotOrder> carried;
  double heaviest = 0;
  for (const ObjectId id : from_top) {
    const double own = bodies[body_of.at(id)].mass;
    heaviest = std::max(heaviest, carried[id] / own);
    const std::vector<const ObjectContact*> below = contacts_below(scene.at(id));
    for (const ObjectContact* entry : below)
      if (!entry->with.is_floor())
        carried[entry->with.object()] += (own + carried[id]) / static_cast<double>(below.size());
  }
  return heaviest;
}

}  // namespace trivet
