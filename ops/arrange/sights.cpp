#include "ops/arrange/sights.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "ops/arrange/sight_grid.h"

namespace trivet {

namespace {

constexpr double kLittle = 1e-9;             // rounding, relative
constexpr size_t kMostToBeConvex = 1 << 16;  // faces x vertices that are looked at

// A solid with all vertices behind all faces; of small meshes only.
bool is_convex_solid(const Shape& shape) {
  const Mesh& mesh = shape.mesh;
  if (shape.mass.rule != MassRule::Volume ||
      mesh.triangles.size() * mesh.vertices.size() > kMostToBeConvex)
    return false;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Index3& t) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const Vec3& v) { return normal.dot(v - a) <= 0; });
  });
}

/// Answer of a kind of sight; another one, which is never asked, nothing.
template <class Answer, class Ask>
Answer ask_sight(const Relation& relation, const Ask& ask) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (std::decay_t<decltype(kind)>::kIsOfSight)
          return ask(kind);
        else
          return Answer();
      },
      relation.kind);
}

}  // namespace

/// Objects of the trial with their places.
class Eyes : public relations::Sight {
 public:
  Eyes(const SightTrial& trial, const Relation& relation)
      : m_trial(trial), m_relation(relation), m_a(body(relation.a)) {
    const World& world = trial.world;
    if (!relation.b.empty()) m_b = body(relation.b);
    // All that stands may cut off a line but both objects of the relation, and the thing's own
    // former place.
    for (const ObjectId id : world.standing()) {
      const std::string& name = world.scene().at(id).name;
      const int t = world.thing_of(name);
      if (name == relation.a || name == relation.b || (t >= 0 && t == trial.thing)) continue;
      if (trial.immovable_only && t >= 0) continue;
      m_others.push_back({body_of(world.scene().at(id)), t, false});
    }
    const bool is_party =
        trial.thing >= 0 && (name_of_thing() == relation.a || name_of_thing() == relation.b);
    if (trial.thing >= 0 && !is_party)
      m_others.push_back({body(name_of_thing()), trial.thing, false});
  }

  double cost() const {
    return ask_sight<double>(m_relation, [&](const auto& kind) {
      return relations::sight_cost_of(m_relation, kind.missing(*this));
    });
  }

  /// Looks which bodies cast a shadow as a whole.
  void find_convex() {
    for (Other& other : m_others) other.is_convex = is_convex_solid(*other.body.shape);
  }

  /// Moves the thing of the trial.
  void move_to(const Pose& pose) {
    m_trial.pose = pose;
    if (is_tried(m_relation.a)) m_a = body(m_relation.a);
    if (is_tried(m_relation.b)) m_b = body(m_relation.b);
    for (Other& other : m_others)
      if (other.thing >= 0 && other.thing == m_trial.thing) other.body = body(name_of_thing());
  }

  /// cost() <= 1, by as few rays as decide it.
  bool holds() const {
    return ask_sight<bool>(m_relation,
                           [&](const auto& kind) { return kind.holds(m_relation, *this); });
  }

  std::vector<size_t> between() const {
    std::vector<size_t> out;
    if (!ask_sight<bool>(m_relation, [](const auto& kind) { return kind.kHasLines; })) return out;
    // Each ray to a is followed as far as a itself; what it meets before is in between.
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
    bool is_convex = false;
  };

  // Behind one convex body: what it hides from a point outside is convex, so that all of a is
  // hidden if the corners of its box are.
  bool is_in_shadow() const {
    return std::any_of(m_others.begin(), m_others.end(), [&](const Other& other) {
      if (!other.is_convex || is_inside(other.body.world_box, eye())) return false;
      for (int i = 0; i < 8; ++i)
        if (!is_behind(other.body, corner_of(m_a.world_box, i))) return false;
      return true;
    });
  }

  static bool is_inside(const Aabb& box, const Vec3& point) {
    return overlaps(box, Aabb{point, point});
  }

  bool is_behind(const Body& body, const Vec3& point) const {
    const Vec3 to = point - eye();
    const double until = (1 - kLittle) * to.norm();
    return until > 0 && hit(body, {eye(), to.normalized()}, until) < until;
  }

  // As seen(): where all rays are cut off before they come to a's box, without a look at a.
  bool sees(const std::function<bool(double)>& is_enough_share) const override {
    // The share is asked for as soon as rays decide it either way.
    const auto is_enough = [&](int num_seen, int num_met) {
      return is_enough_share(num_met ? double(num_seen) / num_met : 0);
    };
    // Cheap proofs go first: the shadow of one convex body, then rays that end before a's box.
    if (!is_enough(0, 1) && is_in_shadow()) return false;
    const std::vector<Ray> all = rays();
    const auto ends_before = [&](const Ray& ray) { return cut_off(ray, entry(ray)); };
    if (!is_enough(0, 1) && std::all_of(all.begin(), all.end(), ends_before)) return false;
    // Only rays that would meet a count; the others pass it by.
    std::vector<std::pair<const Ray*, double>> met;
    met.reserve(all.size());
    for (const Ray& ray : all)
      if (const double until = hit(m_a, ray, kInfinity); until < kInfinity)
        met.emplace_back(&ray, until);
    const int num_met = static_cast<int>(met.size());
    int num_seen = 0, num_left = num_met;
    // Rays are looked at until those seen, or those left, decide.
    for (const auto& [ray, until] : met) {
      if (is_enough(num_seen, num_met)) return true;
      if (!is_enough(num_seen + num_left, num_met)) return false;
      if (!cut_off(*ray, until)) ++num_seen;
      --num_left;
    }
    return is_enough(num_seen, num_met);
  }

  // As nearest(): one ray is enough.
  bool reaches(const std::function<bool(double)>& is_near) const override {
    for (const Ray& ray : rays()) {
      // A ray that cannot be near enough is left out without a look at the scene.
      if (!is_near(entry(ray))) continue;
      const double until = hit(m_a, ray, kInfinity);
      if (is_near(until) && !cut_off(ray, until)) return true;
    }
    return false;
  }

  // Along the ray, not beyond the first point of a: of the sphere about its box.
  double entry(const Ray& ray) const {
    const Aabb& box = m_a.world_box;
    const double radius = box.half_extent().norm() * (1 + kLittle);
    return std::max(0.0, (box.centre() - ray.origin).norm() - radius);
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

  // The obstacle of the last ray is looked at first.
  bool cut_off(const Ray& ray, double until) const {
    // Neighbouring rays mostly meet the same obstacle.
    for (size_t k = 0; k < m_others.size(); ++k) {
      const size_t i = k == 0 ? m_last : k <= m_last ? k - 1 : k;
      if (hit(m_others[i].body, ray, until) < until) return m_last = i, true;
    }
    return false;
  }

  // Share of a's box, seen from above, that b is over.
  double covered() const override {
    int num_met = 0, num_covered = 0;
    for (const Ray& down : rays_down_to(m_a.world_box)) {
      if (!(hit(m_a, down, kInfinity) < kInfinity)) continue;
      ++num_met;
      if (hit(*m_b, {down.origin, Vec3::UnitZ()}, kInfinity) < kInfinity) ++num_covered;
    }
    return num_met ? double(num_covered) / num_met : 0;
  }

  Vec3 eye() const {
    std::optional<Outline> b;
    if (!m_relation.b.empty()) b = outline(m_relation.b);
    return ask_sight<Vec3>(m_relation, [&](const auto& kind) -> Vec3 {
      if constexpr (std::decay_t<decltype(kind)>::kHasLines) return kind.place(b ? &*b : nullptr);
      return Vec3::Zero();
    });
  }

  std::vector<Ray> rays() const { return rays_to(eye(), m_a.world_box); }

  double seen() const override {
    int num_met = 0, num_seen = 0;
    for (const Ray& ray : rays()) {
      const double until = hit(m_a, ray, kInfinity);
      if (!(until < kInfinity)) continue;
      ++num_met;
      if (!cut_off(ray, until)) ++num_seen;
    }
    return num_met ? double(num_seen) / num_met : 0;
  }

  double nearest() const override {
    double out = kInfinity;
    for (const Ray& ray : rays()) {
      // A ray counts only as far as the nearest found so far.
      const double until = hit(m_a, ray, out);
      if (until < out && !cut_off(ray, until)) out = until;
    }
    return out;
  }

  SightTrial m_trial;
  const Relation& m_relation;
  Body m_a;
  std::optional<Body> m_b;
  std::vector<Other> m_others;
  mutable size_t m_last = 0;  // of these, that cut off a ray
};

SightJudge::SightJudge(const SightTrial& trial, const Relation& relation)
    : m_eyes(std::make_unique<Eyes>(trial, relation)) {
  m_eyes->find_convex();
}

SightJudge::~SightJudge() = default;

bool SightJudge::holds_at(const Pose& pose) {
  m_eyes->move_to(pose);
  return m_eyes->holds();
}

double sight_cost(const SightTrial& trial, const Relation& relation) {
  return Eyes(trial, relation).cost();
}

std::vector<size_t> things_between(const SightTrial& trial, const Relation& relation) {
  return Eyes(trial, relation).between();
}

std::optional<Sentence> broken_sight(const World& world) {
  const SightTrial as_it_is{world, -1, {}};
  for (const Relation* r : sights_of(as_it_is))
    if (!(sight_cost(as_it_is, *r) <= 1)) return say("as things come to rest, not: %1", r->text());
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
