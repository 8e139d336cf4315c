#include "ops/settle/friction_candidates.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ops/settle/separation.h"

namespace trivet {
namespace {

constexpr size_t kMaxPivots = 48;
constexpr size_t kMaxTurns = 16;
constexpr size_t kMaxRubbing = 24;      // contacts of the first motion
constexpr double kOnAxis = 4;           // clearances: too near to the axis to slide
constexpr double kLeastSinking = 1e-3;  // of the speed
constexpr double kLeastTurning = 1e-3;  // of the speed of the centre, at half the size
constexpr double kRoom = 1.2;           // for a screw, of what its turn takes at first
constexpr double kFarthestAway = 1.0;   // of a step
/// Turns about contacts and slides keep what they touch: they go before an approximate turn that is
/// no better.
constexpr double kAsGood = 1.02;

double gauss_gain(const RubbingObject& body, const Twist& t) {
  const double metric =
      t.velocity.squaredNorm() + t.turning.dot(Vec3(body.inertia_per_mass * t.turning));
  return metric > 0 ? t.velocity.z() * t.velocity.z() / metric : 0;
}

class Turns {
 public:
  Turns(const std::vector<FrictionContact>& contacts, const RubbingObject& body, bool dilatant)
      : m_contacts(contacts), m_body(body), m_dilatant(dilatant) {}

  void about_point(const Vec3& p) {
    for (const Vec3& axis : sinking_axes(p, m_body.object))
      add(SettleStep::Kind::TurnAboutPoint, p, axis);
  }

  void about_line(const Vec3& p, const Vec3& q) {
    for (const Vec3& axis : sinking_axes(p, q, m_body.object))
      add(SettleStep::Kind::TurnAboutLine, p, axis);
  }

  std::vector<Candidate> take() { return std::move(m_out); }

 private:
  // All contacts beside the axis part; with friction that would hinder the turn otherwise.
  bool parts(const Vec3& point, const Vec3& axis) const {
    return std::all_of(m_contacts.begin(), m_contacts.end(), [&](const FrictionContact& c) {
      const Vec3 speed = axis.cross(c.point - point);
      // Contacts on the axis do not slide, whatever the friction.
      const double total = speed.norm(), along = speed.dot(c.normal);
      if (total <= kOnAxis * m_body.clearance) return true;
      // A dilatant turn opens contacts faster than their cones: friction cannot touch it.
      const double across = (speed - along * c.normal).norm();
      return along >= (m_dilatant ? c.friction * across : kPartingSpeed * total);
    });
  }

  void add(SettleStep::Kind kind, const Vec3& point, const Vec3& axis) {
    if (!parts(point, axis)) return;
    const Vec3 r = m_body.object.centre - point;
    m_out.push_back({kind, turn_to_lowest(point, axis, m_body.object.centre),
                     kAsGood * gauss_gain(m_body, {axis.cross(r), axis})});
  }

  const std::vector<FrictionContact>& m_contacts;
  const RubbingObject& m_body;
  const bool m_dilatant;
  std::vector<Candidate> m_out;
};

class FirstMotion {
 public:
  FirstMotion(const std::vector<FrictionContact>& contacts, const RubbingObject& body)
      : m_contacts(reduced(contacts, kMaxRubbing)), m_body(body) {}

  CoulombMotions run() {
    // A motion that turns is a screw: its turn, and a slide without turning, are exact motions near
    // to it; the screw itself is kept as the last resort.
    const Twist t = solve(true);
    const double turning = 0.5 * m_body.object.size * t.turning.norm();
    if (turning > kLeastTurning * t.velocity.norm()) {
      add_turn(t);
      add_slide(solve(false).velocity);
      m_out.screw = t;
      // The duration lets the fastest point of the object go a part of its size.
      m_out.duration = kSlideStep * m_body.object.size / (t.velocity.norm() + turning);
    } else {
      add_slide(t.velocity);
    }
    return std::move(m_out);
  }

 private:
  Twist solve(bool may_turn) const {
    // An object that may not turn gets no inverse inertia, and slides.
    CoulombBody body{m_body.object.centre, 1, m_body.object.size, Mat3::Zero()};
    if (may_turn) body.inverse_inertia_per_mass = m_body.inertia_per_mass.inverse();
    // Contacts rub with a little less than their friction, so that what slips goes on slipping.
    std::vector<CoulombContact> rubbing;
    for (const FrictionContact& c : m_contacts)
      rubbing.push_back(
          {0, CoulombContact::kGround, c.point, c.normal, kSlidingFriction * c.friction, 0});
    return first_motion({body}, rubbing).twists.front();
  }

  bool stands_against(const Twist& t) const {
    return std::any_of(m_contacts.begin(), m_contacts.end(), [&](const FrictionContact& c) {
      const Vec3 speed = t.at(c.point - m_body.object.centre);
      return speed.dot(c.normal) < -kApproach * (speed.norm() + t.velocity.norm());
    });
  }

  // A screw is no exact motion: its turn alone, until it has gone a part of the size.
  void add_turn(const Twist& screw) {
    const double rate = screw.turning.norm();
    const Vec3 axis = screw.turning / rate;
    // The part of the velocity along the axis is left out; the rest is a pure turn about a point
    // beside the centre.
    const Twist t{screw.velocity - screw.velocity.dot(axis) * axis, screw.turning};
    if (t.velocity.z() > -kLeastSinking * t.velocity.norm() || stands_against(t)) return;
    const Vec3 point = m_body.object.centre + t.turning.cross(t.velocity) / (rate * rate);
    Motion turn = turn_to_lowest(point, axis, m_body.object.centre);
    // The turn ends once the farthest point has gone a step; s is half of a small angle.
    const double angle =
        kSlideStep * m_body.object.size / (t.velocity.norm() / rate + 0.5 * m_body.object.size);
    turn.limit = std::min(turn.limit, 0.5 * angle);
    m_out.exact.push_back({SettleStep::Kind::Slide, turn, gauss_gain(m_body, t)});
  }

  void add_slide(const Vec3& velocity) {
    const double speed = velocity.norm();
    // A slide that hardly sinks is creeping, and no motion.
    if (!(speed > 0) || velocity.z() > -kLeastSinking * speed) return;
    const Twist t{velocity / speed, Vec3::Zero()};
    if (stands_against(t)) return;
    m_out.exact.push_back({SettleStep::Kind::Slide,
                           Motion::translation(t.velocity, kSlideStep * m_body.object.size),
                           kAsGood * gauss_gain(m_body, {velocity, Vec3::Zero()})});
  }

  const std::vector<FrictionContact> m_contacts;
  const RubbingObject& m_body;
  CoulombMotions m_out;
};

}  // namespace

std::vector<Candidate> sticking_turns(const std::vector<FrictionContact>& all,
                                      const RubbingObject& body, bool dilatant) {
  const std::vector<FrictionContact> contacts = reduced(all, kMaxPivots);
  Turns turns(contacts, body, dilatant);
  for (size_t i = 0; i < contacts.size(); ++i) {
    turns.about_point(contacts[i].point);
    for (size_t j = i + 1; j < contacts.size(); ++j)
      turns.about_line(contacts[i].point, contacts[j].point);
  }
  std::vector<Candidate> out = turns.take();
  sort_by_gain(out);
  if (out.size() > kMaxTurns) out.resize(kMaxTurns);
  return out;
}

CoulombMotions coulomb_motions(const std::vector<FrictionContact>& contacts,
                               const RubbingObject& body) {
  if (contacts.empty()) return {};
  return FirstMotion(contacts, body).run();
}

std::optional<ScrewMotions> screw_motions(const std::vector<FrictionContact>& contacts,
                                          const RubbingObject& body, const Twist& screw,
                                          double duration) {
  const double rate = screw.turning.norm();
  const Vec3 axis = screw.turning / rate;
  const Vec3 along = screw.velocity.dot(axis) * axis;
  const Twist turning{screw.velocity - along, screw.turning};
  std::vector<ContactPoint> pressed;  // with gaps that lack what the turn would take
  // The turn would press some contacts together; the object first moves away by what that takes.
  for (const FrictionContact& c : contacts) {
    pressed.push_back(c);
    const double approach = -c.normal.dot(turning.at(c.point - body.object.centre)) * duration;
    pressed.back().gap = approach > 0 ? -kRoom * approach : 0;
  }
  // The smallest motion that opens all gaps frees the way for the turn.
  const Vec3 away = smallest_separating_motion(pressed, 0);
  const double length = away.norm();
  // A way that long means that there is no room to turn.
  if (length > kFarthestAway * kSlideStep * body.object.size) return std::nullopt;
  const Vec3 centre = body.object.centre + turning.turning.cross(turning.velocity) / (rate * rate);
  return ScrewMotions{
      Motion::translation(length > 0 ? Vec3(away / length) : Vec3(Vec3::UnitZ()), length),
      Motion::rotation(centre, axis, std::min(0.5 * rate * duration, 1.0)), along * duration};
}

std::vector<Candidate> frictionless_slide(const std::vector<FrictionContact>& contacts,
                                          const RubbingObject& body) {
  std::vector<Vec3> normals;
  for (const FrictionContact& c : reduced(contacts, kMaxRubbing)) normals.push_back(c.normal);
  // Friction is left out, and the direction nearest to straight down is taken along which all
  // contacts part.
  const Vec3 way = parting_direction(normals, -Vec3::UnitZ(), kPartingSpeed);
  if (normals.empty() || way.z() > -kLeastSinking) return {};
  const Motion slide = Motion::translation(way, kSlideStep * body.object.size);
  return {{SettleStep::Kind::Slide, slide, way.z() * way.z()}};
}

std::vector<Candidate> fall(const std::vector<FrictionContact>& contacts, double limit) {
  const bool hindered = std::any_of(contacts.begin(), contacts.end(),
                                    [](const auto& c) { return c.normal.z() >= kNoSupport; });
  if (hindered) return {};
  return {{SettleStep::Kind::Fall, Motion::translation(-Vec3::UnitZ(), limit), kAsGood}};
}

void sort_by_gain(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
}

}  // namespace trivet
