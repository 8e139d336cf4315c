#include "ops/arrange/sights.h"

#include <algorithm>

#include "ops/arrange/relation_parts.h"
#include "ops/arrange/sight_grid.h"

namespace trivet {
namespace {

/// Objects of the trial with their places.
class Eyes {
 public:
  Eyes(const SightTrial& trial, const Relation& relation)
      : m_trial(trial), m_relation(relation), m_a(body(relation.a)) {
    const World& world = trial.world;
    if (!relation.b.empty()) m_b = body(relation.b);
    for (const ObjectId id : world.standing()) {
      const std::string& name = world.scene().at(id).name;
      const int t = world.thing_of(name);
      if (name == relation.a || name == relation.b || (t >= 0 && t == trial.thing)) continue;
      if (trial.immovable_only && t >= 0) continue;
      m_others.push_back({body_of(world.scene().at(id)), t});
    }
    const bool is_party =
        trial.thing >= 0 && (name_of_thing() == relation.a || name_of_thing() == relation.b);
    if (trial.thing >= 0 && !is_party) m_others.push_back({body(name_of_thing()), trial.thing});
  }

  double cost() const {
    return std::min(kMostSightCost, std::max(0.0, missing()) / m_relation.tolerance);
  }

  std::vector<size_t> between() const {
    std::vector<size_t> out;
    if (m_relation.kind == RelationKind::Under) return out;
    for (const Ray& ray : rays()) {
      const double until = hit(m_a, ray, kInfinity);
      if (!(until < kInfinity)) continue;
      for (const Other& other : m_others)
        if (other.thing >= 0 && other.thing != m_trial.thing && hit(other.body, ray, until) < until)
          out.push_back(static_cast<size_t>(other.thing));
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

 private:
  struct Other {
    Body body;
    int thing;
  };

  double missing() const {
    switch (m_relation.kind) {
      case RelationKind::Under:
        return m_relation.overlap - covered();
      case RelationKind::View:
        return m_relation.overlap - seen();
      default:
        return nearest_in_reach() - m_relation.upper;
    }
  }

  const std::string& name_of_thing() const {
    return m_trial.world.things()[m_trial.thing].thing->object;
  }

  bool is_tried(const std::string& name) const {
    const int t = m_trial.world.thing_of(name);
    return t >= 0 && t == m_trial.thing;
  }

  Body body(const std::string& name) const {
    const Object& object = m_trial.world.scene().at(*m_trial.world.scene().find(name));
    return is_tried(name) ? body_of(object, m_trial.pose) : body_of(object);
  }

  Outline outline(const std::string& name) const {
    const World& world = m_trial.world;
    return is_tried(name) ? world.outline(world.things()[m_trial.thing], m_trial.pose)
                          : world.outline(name);
  }

  static double hit(const Body& body, const Ray& ray, double until) {
    // By the sphere about its box first.
    const Vec3 to = body.world_box.centre() - ray.origin;
    const double along = std::max(0.0, to.dot(ray.direction));
    const double radius = body.world_box.half_extent().norm();
    if ((to - along * ray.direction).squaredNorm() > radius * radius * (1 + 1e-9)) return kInfinity;
    const auto found = first_hit(*body.shape, body.world_from_object, ray, until);
    return found ? found->time : kInfinity;
  }

  bool cut_off(const Ray& ray, double until) const {
    return std::any_of(m_others.begin(), m_others.end(),
                       [&](const Other& o) { return hit(o.body, ray, until) < until; });
  }

  // Share of a's box, seen from above, that b is over.
  double covered() const {
    int num_met = 0, num_covered = 0;
    for (const Ray& down : rays_down_to(m_a.world_box)) {
      if (!(hit(m_a, down, kInfinity) < kInfinity)) continue;
      ++num_met;
      if (hit(*m_b, {down.origin, Vec3::UnitZ()}, kInfinity) < kInfinity) ++num_covered;
    }
    return num_met ? double(num_covered) / num_met : 0;
  }

  std::vector<Ray> rays() const {
    std::optional<Outline> b;
    if (!m_relation.b.empty()) b = outline(m_relation.b);
    return rays_to(eye_of(m_relation, b ? &*b : nullptr), m_a.world_box);
  }

  double seen() const {
    int num_met = 0, num_seen = 0;
    for (const Ray& ray : rays()) {
      const double until = hit(m_a, ray, kInfinity);
      if (!(until < kInfinity)) continue;
      ++num_met;
      if (!cut_off(ray, until)) ++num_seen;
    }
    return num_met ? double(num_seen) / num_met : 0;
  }

  double nearest_in_reach() const {
    double out = kInfinity;
    for (const Ray& ray : rays()) {
      const double until = hit(m_a, ray, out);
      if (until < out && !cut_off(ray, until)) out = until;
    }
    return out;
  }

  const SightTrial& m_trial;
  const Relation& m_relation;
  Body m_a;
  std::optional<Body> m_b;
  std::vector<Other> m_others;
};

}  // namespace

double sight_cost(const SightTrial& trial, const Relation& relation) {
  return Eyes(trial, relation).cost();
}

std::vector<size_t> things_between(const SightTrial& trial, const Relation& relation) {
  return Eyes(trial, relation).between();
}

std::optional<std::string> broken_sight(const World& world) {
  const SightTrial as_it_is{world, -1, {}};
  for (const Relation* r : sights_of(as_it_is))
    if (!(sight_cost(as_it_is, *r) <= 1)) return "as things come to rest, not: " + r->text();
  return std::nullopt;
}

std::vector<const Relation*> sights_of(const SightTrial& trial) {
  std::vector<const Relation*> out;
  const World& world = trial.world;
  const auto is_there = [&](const std::string& name) {
    const int t = world.thing_of(name);
    return name.empty() || (t >= 0 && t == trial.thing) || world.stands(name);
  };
  for (const Relation& r : world.arrangement().relations)
    if (r.is_of_sight() && r.is_hard() && is_there(r.a) && is_there(r.b)) out.push_back(&r);
  return out;
}

}  // namespace trivet
