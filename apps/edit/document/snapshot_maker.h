// Builder of snapshots that share unchanged data. Private.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "apps/edit/document/snapshot.h"
#include "ops/operations/live_move.h"

namespace trivet::edit {

class SnapshotMaker {
 public:
  /// Starts over with another scene: shares no data.
  void forget();
  /// Records changes since the last snapshot, including removed objects.
  void note_changed(std::span<const ObjectId> ids);
  /// @param way  path that led here, if it is to be played back.
  std::shared_ptr<const SceneSnapshot> make(const Scene& scene, double clearance,
                                            std::optional<SettledWay> way);
  /// The last snapshot, with the moving objects in their dragged poses.
  /// @param motion  that is to follow; nullopt: there is none yet.
  std::shared_ptr<const SceneSnapshot> make_drag(const Scene& scene, const LiveMove& live,
                                                 const std::optional<Motion>& motion);
  /// The last snapshot, with what comes down.
  std::shared_ptr<const SceneSnapshot> make_falling(std::shared_ptr<const Object> falling);
  /// The last snapshot, before drags.
  std::shared_ptr<const SceneSnapshot> make_again();

 private:
  std::shared_ptr<const SceneSnapshot> m_last;
  std::vector<ObjectId> m_changed;
  std::uint64_t m_revision = 0, m_committed = 0;
};

}  // namespace trivet::edit
