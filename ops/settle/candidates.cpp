#include "ops/settle/candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/contact/contact_points.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/half_spaces.h"

namespace trivet {
namespace {

constexpr size_t kMaxContacts = 48;
constexpr size_t kMaxCandidates = 16;
constexpr double kQuarterTurn = 1;  // tan(90 degrees / 2)
constexpr size_t kMaxLastResorts = 8;
constexpr int kProjectionSweeps = 200;

bool stands_against(const std::vector<ContactPoint>& contacts, const Vec3& point,
                    const Vec3& axis) {
  // A contact hinders the turn if its point would move against its normal, faster than rounding
  // explains.
  return std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& c) {
    const Vec3 arm = c.point - point;
    return c.normal.dot(axis.cross(arm)) < -kApproach * arm.norm();
  });
}

// The axis nearest to `wanted` about which all contacts but the one at `point` part. Zero if there
// is none.
Vec3 parting_axis(const std::vector<ContactPoint>& contacts, const Vec3& point,
                  const Vec3& wanted) {
  std::vector<HalfSpace<3>> parted;
  for (const ContactPoint& c : contacts) {
    const Vec3 arm = c.point - point;
    // The object's point at the arm has the speed axis x arm; its part along the normal has to be
    // positive.
    const double length = arm.norm();
    if (length == 0) continue;
    const Vec3 g = arm.cross(c.normal) / length;  // speed of parting = g . axis
    const double squared = g.squaredNorm();
    if (squared >= kApproach) parted.push_back({g, kPartingSpeed, squared});
  }
  const Vec3 axis = nearest_inside<3>(parted, wanted, kProjectionSweeps);
  const double length = axis.norm();
  // A short axis means that hardly any room is left between the half spaces.
  return length > 0.05 ? Vec3(axis / length) : Vec3(Vec3::Zero());
}

double gauss_gain(const Vec3& axis, const Vec3& r, double radius_squared) {
  // Kinetic energy against drop: Gauss' principle prefers the motion in which gravity gains most
  // for its mass and inertia.
  const Vec3 speed = axis.cross(r);
  return speed.z() * speed.z() / (radius_squared + speed.squaredNorm());
}

void keep_best(std::vector<Candidate>& candidates, size_t limit) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  if (candidates.size() > limit) candidates.resize(limit);
}

class Enumeration {
 public:
  Enumeration(const std::vector<ContactPoint>& contacts, const SettlingObject& object)
      : m_contacts(contacts), m_object(object) {}

  void fall(double limit) {
    // The object falls freely while no contact bears on it from below, however slightly.
    const bool held = std::any_of(m_contacts.begin(), m_contacts.end(),
                                  [](const ContactPoint& c) { return c.normal.z() >= kNoSupport; });
    if (!held)
      m_out.push_back({SettleStep::Kind::Fall, Motion::translation(-Vec3::UnitZ(), limit), 1});
  }

  void about_point(const Vec3& p) {
    // An object turns about a contact as far as nothing else stands in the way.
    for (const Vec3& axis : sinking_axes(p, m_object))
      if (!stands_against(m_contacts, p, axis)) add(SettleStep::Kind::TurnAboutPoint, p, axis);
  }

  void about_line(const Vec3& p, const Vec3& q) {
    for (const Vec3& axis : sinking_axes(p, q, m_object))
      if (!stands_against(m_contacts, p, axis)) add(SettleStep::Kind::TurnAboutLine, p, axis);
  }

  // Where other contacts stand against the turn: the nearest one that they allow.
  void about_point_parting(const Vec3& p) {
    for (const Vec3& wanted : sinking_axes(p, m_object)) {
      // Free turns are tried elsewhere.
      if (!stands_against(m_contacts, p, wanted)) continue;
      // The turn that is nearest to the wanted one is kept if it still lowers the centre.
      const Vec3 axis = parting_axis(m_contacts, p, wanted);
      if (axis != Vec3::Zero() && axis.cross(m_object.centre - p).z() < 0 &&
          !stands_against(m_contacts, p, axis))
        add(SettleStep::Kind::TurnAboutPoint, p, axis);
    }
  }

  std::vector<Candidate> best(size_t limit) {
    keep_best(m_out, limit);
    return std::move(m_out);
  }

 private:
  void add(SettleStep::Kind kind, const Vec3& point, const Vec3& axis) {
    m_out.push_back({kind, turn_to_lowest(point, axis, m_object.centre),
                     gauss_gain(axis, m_object.centre - point, m_object.radius_squared)});
  }

  const std::vector<ContactPoint>& m_contacts;
  const SettlingObject& m_object;
  std::vector<Candidate> m_out;
};

// --- the paper's cases -----------------------------------------------------------------------

Candidate paper_point(const Vec3& p, const SettlingObject& object) {
  const Vec3 r = object.centre - p;
  // Right above the point any level axis will do.
  const double level = r.head<2>().norm();
  const Vec3 axis =
      level > kTie * object.size ? Vec3(Vec3(-r.y(), r.x(), 0) / level) : Vec3(Vec3::UnitX());
  return {SettleStep::Kind::TurnAboutPoint, turn_to_lowest(p, axis, object.centre), 0};
}

Candidate paper_line(const Vec3& p, const Vec3& q, const SettlingObject& object) {
  // The centre beside the segment turns about the nearer end, as the other one lifts off.
  const Vec3 d = q - p;
  const double along = d.dot(object.centre - p) / d.squaredNorm();
  if (along < 0) return paper_point(p, object);
  if (along > 1) return paper_point(q, object);
  Vec3 axis = d.normalized();
  if (axis.cross(object.centre - p).z() > 0) axis = -axis;
  return {SettleStep::Kind::TurnAboutLine, turn_to_lowest(p, axis, object.centre), 0};
}

// Hull seen from above: the edge or corner nearest to the centre.
std::vector<Candidate> paper_area(const std::vector<ContactPoint>& contacts,
                                  const std::vector<Vec2>& hull, const SettlingObject& object) {
  // The centre above the hull means rest in the paper.
  if (hull_margin(hull, object.centre.head<2>()) >= 0) return {};
  // Corners of the hull are contacts; their height is looked up again.
  const auto lifted = [&](const Vec2& p) {
    return std::find_if(contacts.begin(), contacts.end(),
                        [&](const ContactPoint& c) { return Vec2(c.point.head<2>()) == p; })
        ->point;
  };
  size_t nearest = 0;
  double best = kInfinity;
  for (size_t i = 0; i < hull.size(); ++i) {
    const double d = -hull_margin({hull[i], hull[(i + 1) % hull.size()]}, object.centre.head<2>());
    if (d < best) best = d, nearest = i;
  }
  return {paper_line(lifted(hull[nearest]), lifted(hull[(nearest + 1) % hull.size()]), object)};
}

}  // namespace

Axes sinking_axes(const Vec3& point, const SettlingObject& object) {
  Axes out;
  const Vec3 r = object.centre - point;
  const double level = r.head<2>().norm();
  // The centre beside the point sinks fastest about the level axis across its arm.
  if (level > kTie * object.size) {
    out.add(Vec3(-r.y(), r.x(), 0) / level);
    return out;
  }
  // Right above the point every level axis is as good: eight of them, a part of a turn apart,
  // written without libm.
  const double d = 0.70710678118654752;
  for (const auto& [x, y] : {std::pair(1.0, 0.0),
                             {d, d},
                             {0.0, 1.0},
                             {-d, d},
                             {-1.0, 0.0},
                             {-d, -d},
                             {0.0, -1.0},
                             {d, -d}})
    out.add(Vec3(x, y, 0));
  return out;
}

Axes sinking_axes(const Vec3& p, const Vec3& q, const SettlingObject& object) {
  Axes out;
  const Vec3 d = q - p;
  const double length = d.norm();
  if (length <= kTie * object.size) return out;
  const Vec3 axis = d / length;
  // The sign tells which way round the centre sinks; in a tie both ways may.
  const double down = axis.cross(object.centre - p).z();
  const bool tie = std::abs(down) <= kTie * object.size;
  if (down < 0 || tie) out.add(axis);
  if (down > 0 || tie) out.add(-axis);
  return out;
}

Motion turn_to_lowest(const Vec3& point, const Vec3& axis, const Vec3& centre) {
  const Vec3 r = centre - point;
  // The height of the centre along the turn is a wave: its lowest place ends the motion.
  const double a = r.z() - axis.z() * axis.dot(r), b = axis.cross(r).z();
  // z(t) = const + a cos t + b sin t is lowest at cos t = -a / h, sin t = -b / h.
  const double h = std::sqrt(a * a + b * b);
  // By the half-angle formula, s = sin t / (1 + cos t). A centre that is highest now has h = a, and
  // turns as far as a motion may.
  const double s = h - a > 0 ? -b / (h - a) : kQuarterTurn;
  return Motion::rotation(point, axis, s > 0 && s < kQuarterTurn ? s : kQuarterTurn);
}

std::vector<Candidate> gauss_candidates(const std::vector<ContactPoint>& all,
                                        const SettlingObject& object, double fall_limit) {
  // Pairs grow with the square of the contacts, so that a few have to stand for many.
  const std::vector<ContactPoint> contacts = reduced(all, kMaxContacts);
  Enumeration enumeration(contacts, object);
  enumeration.fall(fall_limit);
  for (size_t i = 0; i < contacts.size(); ++i) {
    enumeration.about_point(contacts[i].point);
    for (size_t j = i + 1; j < contacts.size(); ++j)
      enumeration.about_line(contacts[i].point, contacts[j].point);
  }
  return enumeration.best(kMaxCandidates);
}

std::vector<Candidate> last_resorts(const std::vector<ContactPoint>& all,
                                    const SettlingObject& object) {
  // These turns are about single contacts, and part from all others.
  const std::vector<ContactPoint> contacts = reduced(all, kMaxContacts);
  Enumeration enumeration(contacts, object);
  for (const ContactPoint& c : contacts) enumeration.about_point_parting(c.point);
  return enumeration.best(kMaxLastResorts);
}

std::vector<Candidate> paper_candidates(const std::vector<ContactPoint>& contacts,
                                        const SettlingObject& object, double fall_limit) {
  // An object that touches nothing falls.
  if (contacts.empty())
    return {{SettleStep::Kind::Fall, Motion::translation(-Vec3::UnitZ(), fall_limit), 1}};
  std::vector<Vec2> points;
  points.reserve(contacts.size());
  for (const ContactPoint& c : contacts) points.push_back(c.point.head<2>());
  const std::vector<Vec2> hull = convex_hull(points);
  if (hull.size() > 2) return paper_area(contacts, hull, object);
  if (hull.size() == 1) return {paper_point(contacts.front().point, object)};
  // All above one line: the two that are farthest apart.
  const auto by_xy = [](const ContactPoint& a, const ContactPoint& b) {
    return std::make_tuple(a.point.x(), a.point.y()) < std::make_tuple(b.point.x(), b.point.y());
  };
  const auto [p, q] = std::minmax_element(contacts.begin(), contacts.end(), by_xy);
  return {paper_line(p->point, q->point, object)};
}

}  // namespace trivet
