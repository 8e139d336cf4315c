#include "ops/mend/known_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/motion/compose.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {
namespace {

constexpr double kPointsApart = 5e-4;  // metres between contact points of a pair
constexpr size_t kMostOfPair = 24;
constexpr size_t kDenseOfPair = 6;      // that may be as near to each other as that
constexpr double kOthersApart = 0.004;  // metres, of the others that have the same normal
constexpr double kSameNormalOfPair = 0.97;
constexpr double kWidestAgain = 0.003;     // metres: wider gaps are found once
constexpr double kMarginOfMeeting = 1e-4;  // metres
constexpr std::uint32_t kFloorKey = ~0u;

/// A body's motion; what stays has none.
struct Gone {
  Vec3 shift, turn, centre;

  Gone(const FreeBody& body, const SmallMotion& motion)
      : shift(motion.head<3>()), turn(motion.tail<3>() / (0.5 * body.size)), centre(body.centre) {}
  Vec3 at(const Vec3& point) const { return shift + turn.cross(point - centre); }
};

// The point belongs to the first body so far; its normal belongs to the other one's face.
double share_of_on(ContactFeatures features) {
  if (features == ContactFeatures::VertexFace) return 1;
  return features == ContactFeatures::FaceVertex ? 0 : 0.5;
}

// The nearest would often be those of one place alone, and the pair touch at another, too.
std::vector<ContactPoint> spread(const std::vector<ContactPoint>& nearest_first) {
  std::vector<ContactPoint> out;
  for (const ContactPoint& p : nearest_first) {
    if (out.size() == kMostOfPair) break;
    const bool is_beside = std::any_of(out.begin(), out.end(), [&](const ContactPoint& kept) {
      return (p.point - kept.point).norm() < kOthersApart &&
             p.normal.dot(kept.normal) > kSameNormalOfPair;
    });
    if (out.size() < kDenseOfPair || !is_beside) out.push_back(p);
  }
  return out;
}

void carry(ContactPoint& c, const Gone& on, const Gone& from) {
  const double share = share_of_on(c.features);
  const Vec3 turn = (1 - share) * on.turn + share * from.turn;
  c.gap = std::max(0.0, c.gap + c.normal.dot(on.at(c.point) - from.at(c.point)));
  c.point += share * on.at(c.point) + (1 - share) * from.at(c.point);
  c.normal = (c.normal + turn.cross(c.normal)).normalized();
}

}  // namespace

SmallMotion KnownContacts::Was::motion_to(const Pose& now) const {
  return trivet::motion_to(body, pose, now);
}

double KnownContacts::Was::way_to(const Pose& now) const {
  const SmallMotion motion = motion_to(now);
  return motion.head<3>().norm() + motion.tail<3>().norm();
}

/// One search over all pairs.
class KnownContacts::Search {
 public:
  Search(KnownContacts& known, const Scene& scene, const std::vector<FreeBody>& bodies, double near)
      : m_known(known), m_scene(scene), m_near(std::min({near, known.m_reach, kWidestAgain})) {
    for (const FreeBody& body : bodies) m_ids.push_back(body.id);
  }

  std::vector<BodyContact> run() {
    for (size_t i = 0; i < m_ids.size(); ++i) {
      // Earlier bodies have seen their contacts with this one already.
      const Neighbourhood later(m_scene, std::span(m_ids).first(i + 1));
      const Body body = body_of(m_scene.at(m_ids[i]));
      const auto with_floor = [&](double reach) { return floor_contact_points(body, reach); };
      if (later.floor()) look_at(static_cast<Index>(i), Support::floor(), with_floor);
      const Neighbours near = later.near(body.world_box, 1.01 * m_known.m_reach);
      for (size_t j = 0; j < near.ids.size(); ++j)
        look_at(static_cast<Index>(i), near.ids[j], [&](double reach) {
          return contact_points(body, near.bodies[j], reach, kFootSlack * m_known.m_clearance);
        });
    }
    return std::move(m_found);
  }

 private:
  template <class Points>
  void look_at(Index on, const Support& with, const Points& points) {
    Pair& pair = m_known.m_pairs[{id_of(on).index, key_of(with)}];
    // A pair that has not come near is where it was carried.
    const bool is_new = !pair.is_known;
    const double reach = is_new ? m_known.m_reach : m_near;
    if (!is_new && pair.least - way_of(pair, on, with) > reach) return add(carried(pair, on, with));
    std::vector<BodyContact> touches = touches_of(on, with, points(reach));
    pair.least = reach;
    for (const BodyContact& t : touches) pair.least = std::min(pair.least, t.contact.gap);
    if (!is_new)
      for (const BodyContact& t : carried(pair, on, with))
        if (t.contact.gap > reach) touches.push_back(t);
    add(touches);
    pair = {was(id_of(on)), with.is_floor() ? Was() : was(with.object()), std::move(touches),
            pair.least, true};
  }

  void add(const std::vector<BodyContact>& touches) {
    m_found.insert(m_found.end(), touches.begin(), touches.end());
  }

  std::vector<BodyContact> carried(const Pair& pair, Index on, const Support& with) const {
    const Gone of_on(pair.on.body, pair.on.motion_to(m_scene.at(id_of(on)).pose));
    const Gone of_with =
        with.is_floor() ? Gone(pair.on.body, SmallMotion::Zero())
                        : Gone(pair.with.body, pair.with.motion_to(m_scene.at(with.object()).pose));
    std::vector<BodyContact> out = pair.touches;
    for (BodyContact& t : out) {
      t.on = on, t.from = index_of(with);
      carry(t.contact, of_on, of_with);
    }
    return out;
  }

  ObjectId id_of(Index body) const { return m_ids[static_cast<size_t>(body)]; }

  Was was(ObjectId id) const {
    const Object& object = m_scene.at(id);
    return {{id, object.centre_of_mass(), 0, size_of(object)}, object.pose};
  }

  // Metres, of both together at most.
  double way_of(const Pair& pair, Index on, const Support& with) const {
    const double own = pair.on.way_to(m_scene.at(id_of(on)).pose);
    return with.is_floor() ? own : own + pair.with.way_to(m_scene.at(with.object()).pose);
  }

  std::vector<BodyContact> touches_of(Index on, const Support& with,
                                      const std::vector<ContactPoint>& found) const {
    std::vector<ContactPoint> points = merged(found, kPointsApart);
    std::stable_sort(points.begin(), points.end(),
                     [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
    points = spread(points);
    const double friction = ContactFriction{}.of(m_scene, id_of(on), with);
    std::vector<BodyContact> out;
    out.reserve(points.size());
    for (const ContactPoint& p : points) out.push_back({on, index_of(with), with, friction, p});
    return out;
  }

  Index index_of(const Support& with) const {
    if (with.is_floor()) return BodyContact::kGround;
    const auto at = std::find(m_ids.begin(), m_ids.end(), with.object());
    return at == m_ids.end() ? BodyContact::kGround : static_cast<Index>(at - m_ids.begin());
  }

  KnownContacts& m_known;
  const Scene& m_scene;
  const double m_near;
  std::vector<ObjectId> m_ids;
  std::vector<BodyContact> m_found;
};

std::uint32_t KnownContacts::key_of(const Support& s) {
  return s.is_floor() ? kFloorKey : s.object().index;
}

std::vector<BodyContact> KnownContacts::find(const Scene& scene,
                                             const std::vector<FreeBody>& bodies, double near) {
  return Search(*this, scene, bodies, near).run();
}

bool KnownContacts::may_meet(ObjectId a, const Pose& pose_a, ObjectId b, const Pose& pose_b) const {
  const auto at = m_pairs.find({a.index, b.index});
  if (at == m_pairs.end() || !at->second.is_known) return true;
  const Pair& pair = at->second;
  return pair.least - pair.on.way_to(pose_a) - pair.with.way_to(pose_b) < kMarginOfMeeting;
}

}  // namespace trivet
