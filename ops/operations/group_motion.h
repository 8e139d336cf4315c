// Exact motions of rigid groups of bodies, as their first twists begin them.
#pragma once

#include <vector>

#include "core/scene/transaction.h"
#include "ops/operations/operation_run.h"
#include "ops/operations/twist_groups.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// A contact that ended a motion of a body; the normal points to it.
struct Blocker {
  Index body = 0;
  Support with;
  Vec3 point, normal;
};

/// Moves bodies of a BeginningMotion in the scene, and links none. Refers to its arguments.
class GroupMotion {
 public:
  /// @param ids  of the motion's bodies.
  GroupMotion(Transaction& transaction, const BeginningMotion& motion,
              const std::vector<ObjectId>& ids, double clearance, OperationRun& run)
      : m_transaction(transaction),
        m_motion(motion),
        m_ids(ids),
        m_clearance(clearance),
        m_run(run) {}

  /// Takes a group along its twist for `duration` seconds, or as far as it gets.
  /// @return seconds. What ends it is the last of blockers().
  double advance(const TwistGroup& group, double duration);
  const std::vector<Blocker>& blockers() const { return m_blockers; }
  std::int64_t num_queries() const { return m_num_queries; }

 private:
  Vec3 away_from_pressed(const TwistGroup& group, const Twist& turning, double duration) const;
  double turn(const TwistGroup& group, double duration);
  double slide(const TwistGroup& group, const Vec3& way);
  double execute(const TwistGroup& group, const Motion& motion);

  Transaction& m_transaction;
  const BeginningMotion& m_motion;
  const std::vector<ObjectId>& m_ids;
  const double m_clearance;
  OperationRun& m_run;
  std::vector<Blocker> m_blockers;
  std::int64_t m_num_queries = 0;
};

}  // namespace trivet
