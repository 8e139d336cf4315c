// Which contacts carry what.
#include <algorithm>
#include <set>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/scene.h"

namespace trivet {

Contact reversed(const Contact& contact) { return seen_from_support(contact); }

bool holds_up(const Contact& contact) {
  return contact.normal.z() > kSupportNormalZ ||
         std::any_of(contact.points.begin(), contact.points.end(),
                     [](const ContactPoint& p) { return p.normal.z() > kSupportNormalZ; });
}

bool weighs_on(const Contact& contact) {
  return contact.normal.z() < -kSupportNormalZ ||
         std::any_of(contact.points.begin(), contact.points.end(),
                     [](const ContactPoint& p) { return p.normal.z() < -kSupportNormalZ; });
}

bool holds_up(const ObjectContact& entry) { return entry.carries || holds_up(entry.contact); }
bool weighs_on(const ObjectContact& entry) { return entry.is_carried || weighs_on(entry.contact); }

std::vector<ObjectId> unsound_supports(const Scene& scene, ObjectId id) {
  const auto is_unsound = [](ObjectState state) {
    return state == ObjectState::Held || state == ObjectState::Invalid ||
           state == ObjectState::Unsupported;
  };
  // The search goes down from support to support, each once; a fixed one needs none.
  std::vector<ObjectId> waiting{id}, out;
  std::set<std::uint32_t> seen{id.index};
  for (size_t i = 0; i < waiting.size(); ++i) {
    if (scene.at(waiting[i]).fixed) continue;
    for (const ObjectContact& entry : scene.at(waiting[i]).contacts) {
      if (entry.with.is_floor() || !holds_up(entry)) continue;
      const ObjectId below = entry.with.object();
      if (!seen.insert(below.index).second) continue;
      waiting.push_back(below);
      if (is_unsound(scene.at(below).state)) out.push_back(below);
    }
  }
  scene.sort(out);
  return out;
}

namespace {

void sort_by_slot(std::vector<ObjectId>& ids) {
  std::sort(ids.begin(), ids.end(), [](ObjectId a, ObjectId b) { return a.index < b.index; });
}

}  // namespace

LoadSupport load_support(const Scene& scene) {
  LoadSupport out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    LoadSupport::Entry entry{id, false, {}, {}};
    // A contact may both hold the object up and bear on it, by different points.
    for (const ObjectContact& l : object.contacts) {
      if (holds_up(l)) {
        if (l.with.is_object())
          entry.supports.push_back(l.with.object());
        else
          entry.on_floor = true;
      }
      if (l.with.is_object() && weighs_on(l)) entry.loads.push_back(l.with.object());
    }
    // Lists are sorted by slot, so that they do not depend on who was linked first.
    sort_by_slot(entry.supports);
    sort_by_slot(entry.loads);
    out.entries.push_back(std::move(entry));
  }
  return out;
}

}  // namespace trivet
