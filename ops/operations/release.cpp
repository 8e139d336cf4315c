// Release of objects that were left without support: each settles, the lowest first.
#include <algorithm>
#include <map>
#include <set>

#include "ops/operations/commit.h"

namespace trivet {
namespace {

constexpr int kMaxReleases = 8;  // of one object in one operation

class Release {
 public:
  Release(Transaction& transaction, OperationRun& run, double clearance,
          const std::vector<ObjectId>& only, OperationResult& result)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_run(run),
        m_clearance(clearance),
        m_only(only),
        m_result(result) {}

  void run() {
    // The lowest goes first, as others may come to rest on it.
    while (const auto id = lowest()) {
      const std::string name = m_scene.at(*id).name;
      ++m_tries[name];
      m_stuck.insert(name);
      // A move may free those that were stuck.
      if (release(*id)) m_stuck.clear(), add_name(m_result.settled, name);
      if (m_run.interrupt.reason()) return;
    }
    // Objects that came to rest meanwhile are unsupported no more.
    const auto still_waits = [&](const std::string& name) {
      return m_scene.at(*m_scene.find(name)).state == ObjectState::Unsupported;
    };
    std::erase_if(m_result.unsupported, [&](const std::string& n) { return !still_waits(n); });
    std::erase_if(m_result.settled, still_waits);
  }

 private:
  bool may_be_released(const std::string& name) const {
    const auto tries = m_tries.find(name);
    return !m_stuck.contains(name) && (tries == m_tries.end() || tries->second < kMaxReleases);
  }

  bool is_wanted(ObjectId id) const {
    return m_only.empty() || std::find(m_only.begin(), m_only.end(), id) != m_only.end();
  }

  std::optional<ObjectId> lowest() const {
    std::optional<ObjectId> best;
    double best_z = kInfinity;
    for (const std::string& name : m_result.unsupported) {
      const std::optional<ObjectId> id = m_scene.find(name);
      if (!id || !may_be_released(name) || !is_wanted(*id)) continue;
      if (m_scene.at(*id).state != ObjectState::Unsupported) continue;
      const double z = m_scene.world_box(*id).lower.z();
      if (z < best_z) best_z = z, best = id;
    }
    return best;
  }

  // Plan of one object that settles from where it is; without changes_scene if it cannot.
  MovePlan plan_release(ObjectId id) {
    MovePlan plan;
    plan.group.emplace(m_scene, id, std::span<const ObjectId>(), m_clearance, m_run.options,
                       m_run.detector);
    // Fixed and locked loads hold the object where it is.
    if (refuse_immovable(m_scene, plan.group->ids())) return plan;
    const SettleOutcome outcome = plan.group->settle(&m_run.interrupt);
    if (m_run.interrupt.reason()) return plan;
    const bool rests = outcome.status == SettleOutcome::Status::AtRest;
    const bool wedged =
        outcome.status == SettleOutcome::Status::Wedged && m_run.options.accept_wedged;
    plan.result.steps = outcome.steps;
    plan.otherwise = rests ? ObjectState::Stable : ObjectState::Wedged;
    plan.settled = true;
    // A release counts if it ends at rest, or wedged where that is accepted, and passes the exact
    // test.
    plan.changes_scene =
        (rests || wedged) && !refuse_interpenetration(m_scene, plan.group->placements(), true);
    return plan;
  }

  /// @return whether anything has changed.
  bool release(ObjectId id) {
    MovePlan plan = plan_release(id);
    if (!plan.changes_scene) return false;
    const OperationResult done = commit(m_transaction, std::move(plan), m_run);
    m_result.num_motions += static_cast<int>(done.steps.size());
    for (const std::string& left : done.unsupported) add_name(m_result.unsupported, left);
    return !done.steps.empty() || m_scene.at(id).state != ObjectState::Unsupported;
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  OperationRun& m_run;
  double m_clearance;
  const std::vector<ObjectId>& m_only;  // empty: all
  OperationResult& m_result;
  std::map<std::string, int> m_tries;
  std::set<std::string> m_stuck;  // cannot settle as long as nothing else does
};

}  // namespace

void settle_unsupported(Transaction& transaction, OperationRun& run, double clearance,
                        const std::vector<ObjectId>& only, OperationResult& result) {
  Release(transaction, run, clearance, only, result).run();
}

}  // namespace trivet
