#include "perf/sampled_starts.h"

#include <algorithm>

#include "core/contact/body.h"
#include "core/exact/interpenetration.h"
#include "ops/free_places/distance_query.h"

namespace trivet::perf {
namespace {

using farm::Decision;

constexpr double kAbove = 0.01;     // metres from the support's box to that of the object
constexpr double kInHeight = 0.15;  // metres; range of the start's height over a container
constexpr double kLift = 0.005;     // metres between what rests on each other
constexpr int kDeepest = 8;         // of a pile

// The objects of the scene that are known so far, in their start poses.
class Sampler {
 public:
  Sampler(const farm::SceneSource& source, std::uint64_t k, const Scene& scene)
      : m_source(source), m_k(k), m_scene(scene) {
    for (const ObjectId id : scene.ids())
      if (scene.at(id).placed && scene.at(id).fixed) add(id, scene.at(id).pose);
  }

  Starts run() {
    for (const farm::RecipeGroup& group : m_source.recipe.groups)
      for (int i = 0;; ++i) {
        const auto id = m_scene.find(group.name + "_" + std::to_string(i));
        if (!id) break;
        if (m_scene.at(*id).placed) sample(group, *id);
      }
    return std::move(m_out);
  }

 private:
  struct Entry {
    std::string name, group;
    Body body;
  };

  void add(ObjectId id, const Pose& pose, const std::string& group = "") {
    const Object& object = m_scene.at(id);
    m_there.push_back({object.name, group,
                       Body(*object.shape, world_from_object(pose, object.up, object.scale))});
  }

  // The box in the middle of a range, or anywhere that keeps it inside.
  static double drawn(double lower, double upper, double width, Decision& decision) {
    if (upper - lower > width) return decision.within({lower, upper - width});
    return decision.within({lower, upper}) - width / 2;
  }

  // Lower corner of the object's box, and what it is to come to lie on or in, which may be near.
  std::optional<Vec3> corner(const farm::RecipeGroup& group, const Vec3& size, int number,
                             Decision& decision, std::string& support) const {
    if (const auto* heap = std::get_if<farm::PutHeap>(&group.place)) {
      const Vec2 at = heap->centre + heap->radius * decision.in_disc() - size.head<2>() / 2;
      return Vec3(at.x(), at.y(), heap->height + heap->rise * number);
    }
    const auto* on = std::get_if<farm::PutOn>(&group.place);
    const auto* in = std::get_if<farm::PutIn>(&group.place);
    const std::vector<std::string>& names = on ? on->on : in->in;
    std::vector<const Entry*> supports;
    for (const Entry& there : m_there)
      if (std::ranges::count(names, there.name) + std::ranges::count(names, there.group) > 0)
        supports.push_back(&there);
    if (supports.empty()) return std::nullopt;
    const Entry& chosen = *supports[decision.index(supports.size())];
    support = chosen.name;
    const Aabb& box = chosen.body.world_box;
    const double x = drawn(box.lower.x(), box.upper.x(), size.x(), decision);
    const double y = drawn(box.lower.y(), box.upper.y(), size.y(), decision);
    const double height = on ? kAbove : in->above + decision.within({0, kInHeight});
    return Vec3(x, y, box.upper.z() + height);
  }

  static bool blocks(const Body& a, const Body& b, double keep) {
    if (!overlaps(a.world_box, b.world_box, keep)) return false;
    if (keep > 0 && nearer_than(keep, a, b)) return true;
    const PlacedShape in_a{a.shape, nullptr, a.world_from_object},
        in_b{b.shape, nullptr, b.world_from_object};
    return count_crossings(in_a, in_b, 1) > 0 || count_components_inside(in_a, in_b) > 0 ||
           count_components_inside(in_b, in_a) > 0;
  }

  bool is_free(const Body& body, double keep, const std::string& support) const {
    return std::ranges::none_of(m_there, [&](const Entry& there) {
      return blocks(body, there.body, there.name == support ? 0 : keep);
    });
  }

  Rotation rotation(const farm::RecipeGroup& group, const std::string& name) const {
    Decision turn(m_source.key, m_k, name + "/rotation");
    if (group.rotation == farm::RotationRule::Yaw) return turn.yaw();
    return group.rotation == farm::RotationRule::Any ? turn.any_rotation() : group.given;
  }

  void sample(const farm::RecipeGroup& group, ObjectId id) {
    const Object& object = m_scene.at(id);
    const auto* on = std::get_if<farm::PutOn>(&group.place);
    Decision decision(m_source.key, m_k, "peer/" + object.name);
    Pose pose{rotation(group, object.name), Vec3::Zero()};
    const Body turned(*object.shape, world_from_object(pose, object.up, object.scale));
    const Vec3 size = 2 * turned.world_box.half_extent();
    const int number = std::stoi(object.name.substr(group.name.size() + 1));
    for (int i = 0; i < kSampleTries; ++i) {
      std::string support;
      const auto lower = corner(group, size, number, decision, support);
      if (!lower) break;
      ++m_out.tries;
      pose.translation = *lower - turned.world_box.lower;
      const Body body(*object.shape, world_from_object(pose, object.up, object.scale));
      if (!is_free(body, on ? on->keep : 0, support)) continue;
      m_out.poses[object.name] = pose;
      add(id, pose, group.name);
      return;
    }
    m_out.without.push_back(object.name);
  }

  const farm::SceneSource& m_source;
  std::uint64_t m_k;
  const Scene& m_scene;
  std::vector<Entry> m_there;
  Starts m_out;
};

bool is_over(const Vec3& centre, const Aabb& box) {
  return box.lower.x() <= centre.x() && centre.x() <= box.upper.x() &&
         box.lower.y() <= centre.y() && centre.y() <= box.upper.y() && box.lower.z() <= centre.z();
}

}  // namespace

Starts sampled_starts(const farm::SceneSource& source, std::uint64_t k,
                      const farm::MadeScene& made) {
  return Sampler(source, k, made.run.scene).run();
}

Starts lifted_starts(const farm::MadeScene& made) {
  const Scene& scene = made.run.scene;
  const LoadSupport links = load_support(scene);
  std::map<std::uint32_t, int> level;  // by index
  for (int pass = 0; pass < kDeepest; ++pass)
    for (const LoadSupport::Entry& entry : links.entries)
      for (const ObjectId below : entry.supports)
        if (level[below.index] <= pass)
          level[entry.object.index] = std::max(level[entry.object.index], level[below.index] + 1);
  Starts out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed || object.fixed) continue;
    Pose pose = object.pose;
    pose.translation.z() += kLift * std::max(level[id.index], 1);
    out.poses[object.name] = pose;
  }
  return out;
}

std::vector<std::string> misplaced(const farm::Recipe& recipe, const Scene& scene,
                                   const std::map<std::string, Pose>& poses) {
  const auto placed = [&](const std::string& name) -> std::optional<Affine> {
    const auto id = scene.find(name);
    if (!id) return std::nullopt;
    const Object& object = scene.at(*id);
    const auto moved = poses.find(name);
    if (moved != poses.end()) return world_from_object(moved->second, object.up, object.scale);
    if (object.fixed && object.placed) return object.world_from_object();
    return std::nullopt;
  };
  const auto is_over_one = [&](const std::string& name, const Vec3& centre) {
    const auto is_over_this = [&](const std::string& support) {
      const auto world = placed(support);
      return world &&
             is_over(centre, Body(*scene.at(*scene.find(support)).shape, *world).world_box);
    };
    if (is_over_this(name)) return true;
    for (int i = 0; scene.find(name + "_" + std::to_string(i)); ++i)
      if (is_over_this(name + "_" + std::to_string(i))) return true;
    return false;
  };
  std::vector<std::string> out;
  for (const farm::RecipeGroup& group : recipe.groups) {
    const auto* on = std::get_if<farm::PutOn>(&group.place);
    const auto* in = std::get_if<farm::PutIn>(&group.place);
    if (!on && !in) continue;
    for (int i = 0;; ++i) {
      const std::string name = group.name + "_" + std::to_string(i);
      const auto id = scene.find(name);
      if (!id) break;
      const auto world = placed(name);
      if (!world) continue;
      const Vec3 centre = world->apply(scene.at(*id).shape->mass.centre);
      if (std::ranges::none_of(on ? on->on : in->in,
                               [&](const std::string& s) { return is_over_one(s, centre); }))
        out.push_back(name);
    }
  }
  return out;
}

}  // namespace trivet::perf
