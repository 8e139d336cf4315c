#include "ops/arrange/world.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/quoted.h"
#include "ops/arrange/stable_poses.h"
#include "ops/arrange/zones.h"
#include "ops/operations/carried_with.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kSideDeg = 30;
constexpr size_t kMaxRests = 6;  // stable poses that are tried, the likely ones

[[noreturn]] void refuse(const Sentence& what) { throw Error(Error::Kind::BadInput, what); }

std::vector<std::string> names_in(const Scene& scene) {
  std::vector<std::string> out;
  for (const ObjectId id : scene.ids()) out.push_back(scene.at(id).name);
  return out;
}

bool lies_on_side(const StablePose& pose) { return std::abs(pose.tilt_deg - 90) <= kSideDeg; }

void check_name(const Scene& scene, const std::string& name, const Sentence& where) {
  if (!scene.find(name))
    refuse(say("%1: there is no object %2%3", where, quoted(name),
               did_you_mean(name, names_in(scene))));
}

}  // namespace

World::World(Transaction& transaction, const Arrangement& arrangement,
             const ArrangeSetting& setting)
    : m_transaction(&transaction), m_arrangement(arrangement), m_setting(setting) {
  // Names are checked before anything is computed, so that mistakes are told first.
  check_names();
  m_things.reserve(m_arrangement.things.size());
  for (const Thing& thing : m_arrangement.things) {
    m_thing_of[thing.object] = static_cast<int>(m_things.size());
    m_things.push_back(model_of(thing));
  }
  // Each thing knows the relations that name it.
  for (size_t r = 0; r < m_arrangement.relations.size(); ++r)
    for (const std::string& name : {m_arrangement.relations[r].a, m_arrangement.relations[r].b})
      if (const int t = thing_of(name); t >= 0) m_things[t].relations.push_back(r);
  check_cycles();
  check_zones();
  m_zones.reserve(m_arrangement.zones.size());
  for (const Zone& zone : m_arrangement.zones) m_zones.push_back(object_of(zone));
  find_hulls();
  find_planes();
  // All things leave the scene, and come back one after the other.
  unplace_things();
}

void World::find_hulls() {
  for (const Relation& r : m_arrangement.relations)
    for (const std::string& name : {r.b, r.about() ? *r.about() : ""}) {
      const auto id = scene().find(name);
      if (id && !r.is_support() && thing_of(name) < 0 && !m_hulls.count(name))
        m_hulls[name] = facts().hull(scene().at(*id));
    }
}

void World::check_zones() const {
  for (const Zone& zone : m_arrangement.zones) {
    check_name(scene(), zone.object, zone.text());
    if (!((zone.upper - zone.lower).minCoeff() > 2 * kZoneSlack))
      refuse(say("%1: accepted: a box whose upper corner is above its lower one", zone.text()));
  }
}

// Symmetric about an object: about the plane between its left and its right.
void World::find_planes() {
  for (Relation& r : m_arrangement.relations) {
    if (!r.about()) continue;
    const Outline middle = outline(*r.about());
    std::visit([&](auto& kind) { kind.set_about(middle); }, r.kind);
  }
}

void World::check_names() const {
  // Every name has to exist, every thing may have one carrier, and every reference has to stand or
  // to be a thing.
  std::map<std::string, int> seen;
  for (const Thing& thing : m_arrangement.things) {
    check_name(scene(), thing.object, TRIVET_SENTENCE("things"));
    const Object& object = scene().at(*scene().find(thing.object));
    if (object.joint)
      refuse(say("things: %1 hangs in a joint; accepted: objects that may move, onto it, too",
                 quoted(thing.object)));
    if (object.fixed)
      refuse(say("things: %1 is fixed; accepted: objects that may move", quoted(thing.object)));
    if (!object.links.empty())
      refuse(say("things: others hang in %1 by joints; accepted: objects without joints",
                 quoted(thing.object)));
    if (seen[thing.object]++) refuse(say("things: %1 comes twice", quoted(thing.object)));
  }
  std::map<std::string, Sentence> carried;
  const auto carry = [&](const std::string& name, const Sentence& what) {
    if (!seen.count(name))
      refuse(say("%1: %2 is none of the things to arrange", what, quoted(name)));
    const auto [it, is_new] = carried.emplace(name, what);
    if (!is_new) refuse(say("%1: %2 says already what carries %3", what, it->second, quoted(name)));
  };
  const auto stand = [&](const std::string& name, const Sentence& what) {
    if (!seen.count(name) && !stands(name))
      refuse(say("%1: %2 stands nowhere and is none of the things to arrange", what, quoted(name)));
  };
  for (const Relation& r : m_arrangement.relations) {
    check_name(scene(), r.a, r.text());
    if (!r.b.empty() && r.b != "floor") check_name(scene(), r.b, r.text());
    if (r.a == r.b) refuse(say("%1: a thing has no relation to itself", r.text()));
    if (r.is_support()) carry(r.a, r.text());
    if (!seen.count(r.a) && !seen.count(r.b))
      refuse(say("%1: neither is one of the things to arrange", r.text()));
    stand(r.a, r.text());
    if (const std::string* const about = r.about()) {
      check_name(scene(), *about, r.text());
      if (seen.count(*about) || !stands(*about))
        refuse(say("%1: %2 is no object that stands already; accepted for \"about\": one that does",
                   r.text(), quoted(*about)));
    }
    if (!r.b.empty() && r.b != "floor") stand(r.b, r.text());
  }
  for (const Pattern& pattern : m_arrangement.patterns) {
    if (pattern.things.empty()) refuse(say("%1: accepted: at least one", pattern.text()));
    if (pattern.on != kFloorName) {
      check_name(scene(), pattern.on, pattern.text());
      stand(pattern.on, pattern.text());
    } else if (!scene().floor) {
      refuse(say("%1: there is no floor", pattern.text()));
    }
    for (const std::string& name : pattern.things) carry(name, pattern.text());
  }
}

// Turns into the poses that a thing may have.
std::vector<Rotation> World::rests_of(const Thing& thing) const {
  using Kind = PoseChoice::Kind;
  const Kind kind = thing.pose.kind;
  if (kind == Kind::AsModelled || kind == Kind::Free) return {Rotation{}};
  const Object& object = scene().at(*scene().find(thing.object));
  // A thing that stands as it was modelled needs no search for poses.
  if (kind == Kind::Upright && facts().stands_as_modelled(object)) return {Rotation{}};
  const std::vector<StablePose>& poses = facts().poses(object);
  if (kind == Kind::Upright) {
    const auto upright = upright_pose(poses);
    if (!upright) refuse(no_upright_pose(thing.object, poses));
    return {upright->rotation};
  }
  if (kind == Kind::Number) {
    if (thing.pose.number < 0 || thing.pose.number >= static_cast<int>(poses.size()))
      refuse(say("%1 has no stable pose %2: there are %3, from 0", quoted(thing.object),
                 thing.pose.number, poses.size()));
    return {poses[thing.pose.number].rotation};
  }
  // The likely poses come first; a few are enough.
  std::vector<Rotation> out;
  for (const StablePose& pose : poses)
    if (out.size() < kMaxRests && (kind != Kind::Side || lies_on_side(pose)))
      out.push_back(pose.rotation);
  if (out.empty())
    refuse(
        say(kind == Kind::Side
                ? TRIVET_SENTENCE("%1 does not lie on its side: it has no stable pose with its up "
                                  "within 30 degrees of level")
                : TRIVET_SENTENCE("%1 has no stable pose"),
            quoted(thing.object)));
  return out;
}

ThingModel World::model_of(const Thing& thing) const {
  ThingModel out;
  out.thing = &thing;
  out.id = *scene().find(thing.object);
  const Object& object = scene().at(out.id);
  out.points = facts().hull(object);
  const auto front = m_arrangement.fronts.find(thing.object);
  // A thing's front is -y unless the arrangement says otherwise.
  out.front = front == m_arrangement.fronts.end() ? Vec3(-Vec3::UnitY()) : front->second;
  for (const Rotation& rotation : rests_of(thing)) {
    const Pose pose{rotation, Vec3::Zero()};
    Outline seen = outline(out, pose);
    std::vector<Vec3> rim = rim_of(out.points, object, pose, seen);
    out.rests.push_back({rotation, std::move(seen), std::move(rim)});
  }
  // The area orders things: large ones are placed first.
  const Outline& seen = out.rests.front().outline;
  for (size_t i = 0; i < seen.hull.size(); ++i)
    out.area += 0.5 * cross(seen.hull[i], seen.hull[(i + 1) % seen.hull.size()]);
  return out;
}

void World::check_cycles() const {
  // The way down from each thing has to end; after as many steps as there are things it goes round.
  for (const ThingModel& start : m_things) {
    std::string at = start.thing->object;  // and down
    for (size_t steps = 0; steps <= m_things.size(); ++steps) {
      const int t = thing_of(at);
      if (t < 0) break;
      std::string below;
      if (const Relation* r = support_of(m_things[t])) below = r->b;
      for (const Pattern& p : m_arrangement.patterns)
        if (std::count(p.things.begin(), p.things.end(), at)) below = p.on;
      if (below.empty()) break;
      if (below == start.thing->object)
        refuse(say("%1 would have to carry itself: it lies on what it carries",
                   quoted(start.thing->object)));
      at = below;
    }
  }
}

void World::unplace_things() {
  for (const ThingModel& thing : m_things) {
    if (!object(thing).placed) continue;
    // A thing may not take along what stays.
    const std::vector<ObjectId> all = carried_with(scene(), thing.id);
    for (const ObjectId id : all)
      if (thing_of(scene().at(id).name) < 0)
        refuse(say("things: %1 carries %2, which is none of the things to arrange",
                   quoted(object(thing).name), quoted(scene().at(id).name)));
  }
  // The highest first: loads before what carries them.
  std::vector<const ThingModel*> order;
  order.reserve(m_things.size());
  for (const ThingModel& thing : m_things)
    if (object(thing).placed) order.push_back(&thing);
  const auto bottom = [&](const ThingModel* t) { return scene().world_box(t->id).lower.z(); };
  std::stable_sort(order.begin(), order.end(),
                   [&](const ThingModel* x, const ThingModel* y) { return bottom(x) > bottom(y); });
  for (const ThingModel* thing : order) perform(UnplaceOperation{{object(*thing).name}});
}

OperationResult World::perform(const Operation& operation) {
  return trivet::perform(*m_transaction, operation, m_setting.settle, m_setting.context);
}

int World::thing_of(const std::string& name) const {
  const auto it = m_thing_of.find(name);
  return it == m_thing_of.end() ? -1 : it->second;
}

bool World::stands(const std::string& name) const {
  const auto id = scene().find(name);
  return id && scene().at(*id).placed;
}

Outline World::outline(const ThingModel& thing, const Pose& pose) const {
  return outline_of(thing.points, scene().at(thing.id), pose, thing.front);
}

Outline World::outline(const ThingModel& thing, const Rest& rest, const Rotation& turn) const {
  return outline_of(rest.rim, scene().at(thing.id),
                    {(turn * rest.rotation).normalized(), Vec3::Zero()}, thing.front);
}

Outline World::outline(const std::string& name) const {
  const Object& object = scene().at(*scene().find(name));
  // A thing's outline is that of its hull where it stands now.
  if (const int t = thing_of(name); t >= 0) return outline(m_things[t], object.pose);
  const auto given = m_arrangement.fronts.find(name);
  const Vec3 front = given == m_arrangement.fronts.end() ? Vec3(-Vec3::UnitY()) : given->second;
  const auto hull = m_hulls.find(name);
  return outline_of(hull == m_hulls.end() ? facts().hull(object) : hull->second, object,
                    object.pose, front);
}

std::vector<ObjectId> World::standing() const {
  std::vector<ObjectId> out;
  for (const ObjectId id : scene().ids())
    if (scene().at(id).placed) out.push_back(id);
  return out;
}

const Relation* World::support_of(const ThingModel& thing) const {
  for (const size_t r : thing.relations) {
    const Relation& relation = m_arrangement.relations[r];
    if (relation.is_support() && relation.a == thing.thing->object) return &relation;
  }
  return nullptr;
}

const std::vector<SupportSurface>& World::surfaces(const std::string& name) const {
  return facts().surfaces(scene().at(*scene().find(name)));
}

std::optional<size_t> World::num_levels(const std::string& name) const {
  // A support that may lie in several poses has no certain levels.
  const int t = thing_of(name);
  if (t < 0) return surfaces(name).size();
  const ThingModel& thing = m_things[t];
  if (thing.rests.size() > 1 || thing.thing->pose.kind == PoseChoice::Kind::Free)
    return std::nullopt;
  Object lying = scene().at(thing.id);
  lying.pose = {thing.rests.front().rotation, Vec3::Zero()};
  return facts().surfaces(lying).size();
}

double World::keep(const std::string& a, const std::string& b) const {
  double out = 0;
  // The largest distance that applies to the pair counts.
  const auto pair = std::minmax(a, b);
  for (const KeepApart& keep : m_arrangement.keeps) {
    const auto named = [&](const std::string& name) {
      return std::count(keep.things.begin(), keep.things.end(), name) > 0;
    };
    if (keep.distance <= out || (!named(a) && !named(b))) continue;
    const auto exempt = [&](const std::pair<std::string, std::string>& p) {
      return p.first == pair.first && p.second == pair.second;
    };
    if (std::none_of(keep.except.begin(), keep.except.end(), exempt)) out = keep.distance;
  }
  return out;
}

double World::clearance(const ThingModel& thing) const {
  const double usual = clearance_of(scene(), m_setting.settle);
  if (usual > 0) return usual;
  // The first object of the scene.
  return default_clearance(scene(), body_of(object(thing), Pose{}).world_box);
}

}  // namespace trivet
