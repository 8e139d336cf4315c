#include "ops/arrange/sights.h"

#include <algorithm>

#include "core/index/ray.h"

namespace trivet {
namespace {

constexpr int kRaysAcross = 8;
constexpr double kAbove = 1e-6;  // metres over a, where rays up from it begin

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

  double cost() {
    switch (m_relation.kind) {
      case RelationKind::Under:
        return std::max(0.0, m_relation.overlap - covered()) / m_relation.tolerance;
      case RelationKind::View:
        return std::max(0.0, m_relation.overlap - seen()) / m_relation.tolerance;
      default:
        return std::max(0.0, nearest_in_reach() - m_relation.upper) / m_relation.tolerance;
    }
  }

  std::vector<size_t> between() {
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

  const std::string& name_of_thing() const {
    return m_trial.world.things()[m_trial.thing].thing->object;
  }

  Body body(const std::string& name) const {
    const World& world = m_trial.world;
    const Object& object = world.scene().at(*world.scene().find(name));
    const int t = world.thing_of(name);
    return t >= 0 && t == m_trial.thing ? body_of(object, m_trial.pose) : body_of(object);
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
    const Aabb& box = m_a.world_box;
    int num_met = 0, num_covered = 0;
    for (int i = 0; i < kRaysAcross * kRaysAcross; ++i) {
      const Vec2 cell((i % kRaysAcross + 0.5) / kRaysAcross, (i / kRaysAcross + 0.5) / kRaysAcross);
      const Vec2 at =
          box.lower.head<2>() + cell.cwiseProduct(Vec2(box.upper.head<2>() - box.lower.head<2>()));
      const Ray down{Vec3(at.x(), at.y(), box.upper.z() + kAbove), -Vec3::UnitZ()};
      if (!(hit(m_a, down, kInfinity) < kInfinity)) continue;
      ++num_met;
      if (hit(*m_b, {down.origin, Vec3::UnitZ()}, kInfinity) < kInfinity) ++num_covered;
    }
    return num_met ? double(num_covered) / num_met : 0;
  }

  Vec3 eye() const {
    if (m_relation.eye) return *m_relation.eye;
    const Vec3 centre = m_b->world_box.centre();
    return {centre.x(), centre.y(), m_b->world_box.lower.z() + m_relation.eye_height};
  }

  // From the eye through a grid on the rectangle that holds a's box as it is seen.
  std::vector<Ray> rays() const {
    const Vec3 from = eye(), to = m_a.world_box.centre() - from;
    if (!(to.norm() > 0)) return {};
    const Vec3 ahead = to.normalized();
    const Vec3 aside = (std::abs(ahead.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX());
    const Vec3 right = ahead.cross(aside).normalized(), up = right.cross(ahead);
    Vec2 lower = Vec2::Constant(kInfinity), upper = -lower;
    const Aabb& box = m_a.world_box;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner(i & 1 ? box.upper.x() : box.lower.x(),
                        i & 2 ? box.upper.y() : box.lower.y(),
                        i & 4 ? box.upper.z() : box.lower.z());
      const Vec3 v = corner - from;
      if (!(v.dot(ahead) > 0)) return {{from, ahead}};  // the eye is in it, or nearly
      const Vec2 p(v.dot(right) / v.dot(ahead), v.dot(up) / v.dot(ahead));
      lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
    }
    std::vector<Ray> out;
    out.reserve(kRaysAcross * kRaysAcross);
    for (int i = 0; i < kRaysAcross * kRaysAcross; ++i) {
      const Vec2 cell((i % kRaysAcross + 0.5) / kRaysAcross, (i / kRaysAcross + 0.5) / kRaysAcross);
      const Vec2 p = lower + cell.cwiseProduct(Vec2(upper - lower));
      out.push_back({from, (ahead + p.x() * right + p.y() * up).normalized()});
    }
    return out;
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
