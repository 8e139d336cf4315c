#include "apps/edit/tools/placing.h"

#include <algorithm>
#include <cmath>

namespace trivet::edit {
namespace {

constexpr double kWall = 0.1;    // a face is a wall where its normal's z is no larger
constexpr double kClose = 0.01;  // of the object's size: above the point where it is put down
constexpr double kLip = 0.1;     // of its height: what hangs over less than that is no ceiling
constexpr int kMostLips = 4;     // over one another
constexpr double kRoom = 0.001;  // of the object's size: distance from walls and ceilings

bool overlap_from_above(const Aabb& a, const Aabb& b) {
  return a.lower.x() <= b.upper.x() && b.lower.x() <= a.upper.x() && a.lower.y() <= b.upper.y() &&
         b.lower.y() <= a.upper.y();
}

/// Search for the start of one object.
class PutStart {
 public:
  PutStart(const SceneSnapshot& scene, const Object& object, const std::vector<ObjectId>& moving,
           const Picked& at, double height)
      : m_scene(scene), m_object(object), m_moving(moving), m_at(at), m_height(height) {
    m_object.pose = {object.pose.rotation, Vec3::Zero()};
    shift(at.point.head<2>() - m_object.centre_of_mass().head<2>());
    m_room = kRoom * m_box.diagonal();
  }

  Pose near() const { return at_bottom(m_at.point.z() + m_height); }

  Pose usual() {
    const Vec3& normal = m_at.normal;
    if (normal.z() > kWall) return on_surface();
    if (normal.head<2>().norm() > kWall) return beside_wall();
    return at_bottom(highest_below(m_at.point.z()));  // an underside
  }

 private:
  void shift(const Vec2& by) {
    m_object.pose.translation.head<2>() += by;
    m_box = world_box(m_object);
  }

  Pose at_bottom(double z) const {
    Pose out = m_object.pose;
    out.translation.z() = z - m_box.lower.z();
    return out;
  }

  /// z of the lowest thing above a point; nullopt: the open sky.
  std::optional<double> ceiling_above(const Vec3& point) const {
    const auto hit = pick(m_scene, {point, Vec3::UnitZ()}, m_moving);
    return hit ? std::optional(hit->point.z()) : std::nullopt;
  }

  /// The same, without lips of saucers and folds of cloths over the point.
  std::optional<double> ceiling_over(const Vec3& point) const {
    const double least = m_at.point.z() + kLip * (m_box.upper.z() - m_box.lower.z());
    Vec3 from = point;
    for (int i = 0; i < kMostLips; ++i) {
      const auto ceiling = ceiling_above(from);
      if (!ceiling || *ceiling >= least) return ceiling;
      from.z() = *ceiling + m_room;
    }
    return std::nullopt;
  }

  /// Height of the underside.
  double highest_below(double ceiling) const {
    return ceiling - m_room - (m_box.upper.z() - m_box.lower.z());
  }

  /// Top of what is below the object, the point included, as far as it is not above `limit`.
  double top_below(double limit) const {
    double top = m_at.point.z();
    for (const ObjectSnapshot& o : m_scene.objects) {
      if (!o->placed || std::find(m_moving.begin(), m_moving.end(), o.id) != m_moving.end())
        continue;
      const Aabb other = world_box(*o.object);
      if (other.upper.z() <= limit && overlap_from_above(m_box, other))
        top = std::max(top, other.upper.z());
    }
    return top;
  }

  Pose from_above() const {
    const double floor = m_scene.floor ? 0.0 : -kInfinity;
    return at_bottom(std::max(top_below(kInfinity), floor) + m_height);
  }

  Pose on_surface() const {
    const auto ceiling = ceiling_over(m_at.point + m_room * m_at.normal);
    if (!ceiling) return from_above();
    const double highest = highest_below(*ceiling);
    const double bottom = top_below(highest - m_height) + m_height;
    return at_bottom(std::max(std::min(bottom, highest), m_at.point.z() + m_room));
  }

  // Below an overhang from the height of the point, clear of the wall.
  Pose beside_wall() {
    const Vec3 away = Vec3(m_at.normal.x(), m_at.normal.y(), 0).normalized();
    const Vec3 centre = m_object.centre_of_mass();
    const Vec3 reach = (m_box.upper - centre).cwiseMax(centre - m_box.lower);
    const Vec3 aside = (away.cwiseAbs().dot(reach) + m_room) * away;
    const auto ceiling = ceiling_above(m_at.point + aside);
    if (!ceiling) return from_above();
    shift(aside.head<2>());
    return at_bottom(std::min(m_at.point.z(), highest_below(*ceiling)));
  }

  const SceneSnapshot& m_scene;
  Object m_object;
  const std::vector<ObjectId>& m_moving;
  const Picked& m_at;
  double m_height, m_room = 0;
  Aabb m_box;
};

}  // namespace

Pose put_start(const SceneSnapshot& scene, const Object& object,
               const std::vector<ObjectId>& moving, const Picked& at, double height, bool near) {
  PutStart start(scene, object, moving, at, height);
  return near ? start.near() : start.usual();
}

std::vector<Operation> put_choices(const SceneSnapshot& scene, const Object& object,
                                   const std::vector<ObjectId>& moving, const Picked& at,
                                   PutOperation put, double drop_height, double lift) {
  const double close = kClose * world_box(object).diagonal();
  const int tries = put.tries;
  put.start = put_start(scene, object, moving, at, close + lift, true);
  put.tries = 1;
  std::vector<Operation> choices{put};
  if (is_wall(at)) return choices;
  put.start = put_start(scene, object, moving, at, drop_height + lift, false);
  put.tries = tries;
  choices.push_back(put);
  return choices;
}

Picked place_of(const Object& object) {
  Picked out;
  out.point = object.centre_of_mass();
  out.point.z() = world_box(object).lower.z();
  return out;
}

bool is_wall(const Picked& at) { return at.normal.z() <= kWall; }

double rounded(double value, double step) {
  if (!(step > 0)) return value;
  const double per_unit = std::pow(10, std::ceil(-std::log10(step)));
  return std::round(value * per_unit) / per_unit;
}

}  // namespace trivet::edit
