#include "ops/mend/rest_near.h"

#include <algorithm>

#include "core/scene/transaction.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/part_by_turns.h"

namespace trivet {
namespace {

constexpr double kAirOfNearRest = 2e-5;        // metres between it and what it is parted from
constexpr double kReachOfNearRest = 1;         // tolerances, of gaps that may close
constexpr double kMostReachOfNearRest = 0.04;  // metres
constexpr double kMostStepOfNearRest = 0.006;  // metres, of closing them
constexpr double kFirstShareOfNearRest = 0.5;
constexpr double kBesideNearRest[] = {-0.5, 0.5, -1, 1};  // tolerances, along its fall

/// One object is looked at, which is not placed before and afterwards.
class NearRest {
 public:
  NearRest(Scene& scene, ObjectId id, double tolerance, double clearance,
           const std::function<bool()>& is_over)
      : m_scene(scene), m_id(id), m_clearance(clearance), m_is_over(is_over) {
    m_reach = std::min(kReachOfNearRest * tolerance, kMostReachOfNearRest);
  }

  std::optional<Pose> find(const Pose& given) {
    const std::vector<Placement> members{{m_id, given}};
    const std::vector<Placement> parted =
        part_by_turns(m_scene, members, kAirOfNearRest, m_is_over);
    // A body that is still in another has no contacts that could close.
    if (!crossings_of(m_scene, parted).empty()) return std::nullopt;
    const Pose was = m_scene.at(m_id).pose;
    place(parted[0].pose, true);
    const ClosedGaps closed = close_gaps(m_scene, members,
                                         {m_clearance, m_reach, kMostStepOfNearRest, true,
                                          m_is_over, nullptr, kFirstShareOfNearRest});
    const Pose rest = m_scene.at(m_id).pose;
    place(was, false);
    if (closed.not_held.empty()) return rest;
    m_fall = closed.falls[0];
    return std::nullopt;
  }

  /// The motion by which it falls where nothing held it last.
  const SmallMotion& fall() const { return m_fall; }

 private:
  void place(const Pose& pose, bool placed) {
    edit_object(m_scene, m_id, [&](Object& o) {
      o.pose = pose;
      o.placed = placed;
    });
  }

  Scene& m_scene;
  const ObjectId m_id;
  const double m_clearance;
  double m_reach = 0;
  const std::function<bool()>& m_is_over;
  SmallMotion m_fall = SmallMotion::Zero();
};

}  // namespace

std::optional<Pose> rest_near(Scene& scene, const Placement& given, double tolerance,
                              double clearance, const std::function<bool()>& is_over) {
  return NearRest(scene, given.id, tolerance, clearance, is_over).find(given.pose);
}

std::optional<Pose> rest_near_or_beside(Scene& scene, const Placement& given, double tolerance,
                                        double clearance, const std::function<bool()>& is_over) {
  NearRest near(scene, given.id, tolerance, clearance, is_over);
  std::optional<Pose> out = near.find(given.pose);
  const SmallMotion fall = near.fall();
  if (out || fall.isZero()) return out;
  const Object& object = scene.at(given.id);
  const Affine of_object = world_from_object(given.pose, object.up, object.scale);
  const FreeBody body{given.id, of_object.apply(object.shape->mass.centre), 0, size_of(object)};
  for (const double beside : kBesideNearRest) {
    if (out || (is_over && is_over())) break;
    out = near.find(moved_by(body, given.pose, beside * tolerance * fall));
  }
  return out;
}

}  // namespace trivet
