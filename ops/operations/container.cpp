#include "ops/operations/container.h"

#include <algorithm>
#include <array>

#include "ops/placement/neighbourhood.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kWall = 0.05;     // height of a wall, in parts of the object's size
constexpr double kStep = 0.5;      // height by which the ground may fall, likewise
constexpr double kMuchLarger = 3;  // size of a free object that is a ground, likewise
constexpr double kLevel = 1e-3;    // difference of heights below it, in parts of its own size
constexpr double kHalfRoot = 0.70710678118654752;

/// Heights of a surface over a straight way seen from above: its highest points at both ends, and
/// on all of it. -infinity: there is none.
struct Profile {
  double first = -kInfinity, highest = -kInfinity, last = -kInfinity;

  void add_floor(double top) {
    if (top < 0) return;
    for (double* const height : {&first, &highest, &last}) *height = std::max(*height, 0.0);
  }
};

/// Cut of a vertical plane with surfaces, below a height.
class Cut {
 public:
  Cut(const Vec2& from, const Vec2& to, double top) : m_from(from), m_way(to - from), m_top(top) {
    m_length = m_way.norm();
    m_way /= m_length;
    m_box.extend(Vec3(from.x(), from.y(), top));
    m_box.extend(Vec3(to.x(), to.y(), -kInfinity));
  }

  void add(const Body& body) {
    if (!overlaps(body.world_box, m_box, 0)) return;
    // The tree is walked with a stack of its own; boxes beside the plane are left out.
    const PlacedBvh tree(body);
    std::vector<Index> waiting{0};
    while (!waiting.empty() && !tree.bvh.nodes.empty()) {
      const Index node = waiting.back();
      waiting.pop_back();
      const PlacedBvh::Box box = tree.box(node);
      if (!meets(box)) continue;
      const BvhNode& n = tree.bvh.nodes[node];
      for (Index k = 0; k < n.num_faces; ++k)
        add(body.triangle(tree.bvh.faces[n.second_child + k]));
      if (n.is_leaf()) continue;
      waiting.push_back(n.second_child);
      waiting.push_back(node + 1);
    }
  }

  Profile profile;

 private:
  double along(const Vec3& p) const { return m_way.dot(p.head<2>() - m_from); }
  double beside(const Vec3& p) const {
    const Vec2 d = p.head<2>() - m_from;
    return m_way.x() * d.y() - m_way.y() * d.x();
  }

  bool meets(const PlacedBvh::Box& box) const {
    const double reach = std::abs(m_way.y()) * box.half.x() + std::abs(m_way.x()) * box.half.y();
    const double ahead = std::abs(m_way.x()) * box.half.x() + std::abs(m_way.y()) * box.half.y();
    const double at = along(box.centre);
    return std::abs(beside(box.centre)) <= reach && at + ahead >= 0 && at - ahead <= m_length &&
           box.centre.z() - box.half.z() <= m_top;
  }

  // Points (along, z) in which the plane meets the edges.
  void add(const Triangle& t) {
    std::array<Vec2, 6> points;
    // Each edge that changes sides meets the plane in one point; corners on it count once.
    size_t count = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 &a = t[i], &b = t[(i + 1) % 3];
      const double da = beside(a), db = beside(b);
      if (da == 0) points[count++] = Vec2(along(a), a.z());
      if ((da < 0) == (db < 0) || da == 0 || db == 0) continue;
      const Vec3 p = a + da / (da - db) * (b - a);
      points[count++] = Vec2(along(p), p.z());
    }
    for (size_t i = 0; i < count; ++i)
      for (size_t j = i + 1; j < count; ++j) add(points[i], points[j]);
  }

  // A piece of the cut, clipped to the way and below the top.
  void add(Vec2 a, Vec2 b) {
    // Pieces run from left to right, so that clipping needs one case.
    if (a.x() > b.x()) std::swap(a, b);
    if (a.x() > m_length || b.x() < 0) return;
    const bool is_upright = a.x() == b.x();
    const auto at = [&](double x) {
      return Vec2(x, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    };
    const Vec2 c = is_upright ? a : at(std::max(a.x(), 0.0));
    const Vec2 d = is_upright ? b : at(std::min(b.x(), m_length));
    const double low = std::min(c.y(), d.y()), high = std::max(c.y(), d.y());
    // A wall counts up to the height of the start alone: what is above does not part places.
    if (low > m_top) return;
    raise(profile.highest, std::min(high, m_top));
    for (const Vec2& end : {c, d}) {
      if (end.y() > m_top) continue;
      if (end.x() <= 0) raise(profile.first, end.y());
      if (end.x() >= m_length) raise(profile.last, end.y());
    }
  }

  static void raise(double& height, double to) { height = std::max(height, to); }

  Vec2 m_from, m_way;
  double m_length = 0, m_top;
  Aabb m_box;
};

// Nearly: a cut needs a way.
Profile profile_at(const Body& body, const Vec3& at, const Vec2& way) {
  Cut cut(at.head<2>(), at.head<2>() + way, at.z());
  cut.add(body);
  return cut.profile;
}

// Walls of the body on all sides of the point.
bool is_walled_in(const Body& body, const Vec3& at, double wall) {
  // A point that is open in one of eight directions is not walled in.
  const double reach = body.world_box.diagonal();
  for (int k = 0; k < 8; ++k) {
    const double x = k % 2 ? kHalfRoot : 1, y = k % 2 ? kHalfRoot : 0;
    const Vec2 quarter[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
    const Profile profile = profile_at(body, at, reach * quarter[k / 2]);
    if (!(profile.highest > profile.first + wall)) return false;
  }
  return true;
}

// A body stands on one thing, or level on several, as a table's top does on its legs. Others lean
// or lie in a heap, and what is open above there holds things by chance.
bool stands_as_ground(const Object& object) {
  if (object.contacts.empty() || object.state == ObjectState::Held) return true;
  const Vec3 centre = object.centre_of_mass();
  std::vector<ContactPoint> all;
  double lowest = kInfinity, highest = -kInfinity;
  for (const ObjectContact& entry : object.contacts) {
    const std::vector<ContactPoint>& points = entry.contact.points;
    if (carrying_margin(points, centre) >= 0) return true;
    for (const ContactPoint& p : points) {
      if (p.normal.z() < kCarryingNormalZ) continue;
      all.push_back(p);
      lowest = std::min(lowest, p.point.z());
      highest = std::max(highest, p.point.z());
    }
  }
  return highest - lowest <= kLevel * size_of(object) && carrying_margin(all, centre) >= 0;
}

// A wall rises above both ends.
bool has_wall(const Profile& profile, double size) {
  const double wall = profile.highest - kWall * size;
  return wall > profile.first && wall > profile.last;
}

bool falls_away(const Profile& profile, double size) {
  return profile.last < profile.first - kStep * size;
}

}  // namespace

Container::Container(const Scene& scene, std::vector<ObjectId> moving, const Vec3& at, double size)
    : m_scene(scene), m_moving(std::move(moving)), m_at(at), m_size(size) {
  // The first start tells what it is over: the bodies right below it.
  const Neighbourhood others(scene, m_moving);
  Aabb column;
  column.extend(at);
  column.extend(Vec3(at.x(), at.y(), scene.box().empty() ? at.z() : scene.box().lower.z()));
  const Neighbours below = others.near(column, 0);
  for (size_t k = 0; k < below.ids.size(); ++k) {
    const Object& object = scene.at(below.ids[k]);
    // Fixed bodies are asked later, along each way.
    if (object.fixed || !stands_as_ground(object)) continue;
    const Body& body = below.bodies[k];
    const bool is_below =
        profile_at(body, at, Vec2(body.world_box.diagonal(), 0)).first > -kInfinity;
    if (is_below && (size_of(object) > kMuchLarger * size || is_walled_in(body, at, kWall * size)))
      m_free.push_back(body);
  }
}

Container::Place Container::find(const Vec3& centre) const {
  // The way is a straight line, seen from above.
  const Vec2 from = m_at.head<2>(), to = centre.head<2>();
  Place out = Place::Same;
  if (!((to - from).norm() > 0)) return out;
  const auto judge = [&](const Profile& profile) {
    if (has_wall(profile, m_size)) out = Place::BehindWall;
    if (out == Place::Same && falls_away(profile, m_size)) out = Place::Lower;
  };
  // Each free ground is judged by itself.
  for (const Body& body : m_free) {
    Cut cut(from, to, m_at.z());
    cut.add(body);
    judge(cut.profile);
  }
  // The fixed ones and the floor are one ground together.
  Cut cut(from, to, m_at.z());
  for (const Body& body : fixed_bodies(to)) cut.add(body);
  if (m_scene.floor) cut.profile.add_floor(m_at.z());
  judge(cut.profile);
  return out;
}

std::vector<Body> Container::fixed_bodies(const Vec2& towards) const {
  Aabb box;
  box.extend(m_at);
  box.extend(Vec3(towards.x(), towards.y(), m_scene.box().empty() ? 0 : m_scene.box().lower.z()));
  Neighbours near = Neighbourhood(m_scene, m_moving).near(box, 0);
  std::vector<Body> out;
  for (size_t k = 0; k < near.ids.size(); ++k)
    if (m_scene.at(near.ids[k]).fixed) out.push_back(std::move(near.bodies[k]));
  return out;
}

}  // namespace trivet
