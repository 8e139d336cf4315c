// Makes snapshots that share what has not changed. Private.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "apps/edit/document/snapshot.h"
#include "ops/operations/live_move.h"

namespace trivet::edit {

class SnapshotMaker {
 public:
  /// Another scene: nothing is shared.
  void forget();
  /// Since the last snapshot; objects that are gone, too.
  void note_changed(std::span<const ObjectId> ids);
  /// @param way  that led here, if it is to be watched.
  std::shared_ptr<const SceneSnapshot> make(const Scene& scene, double clearance,
                                            std::optional<SettledWay> way);
  /// The last one, with what moves where the hand has it.
  std::shared_ptr<const SceneSnapshot> make_drag(const Scene& scene, const LiveMove& live);
  /// The last one as it was before drags.
  std::shared_ptr<const SceneSnapshot> make_again();

 private:
  std::shared_ptr<const SceneSnapshot> m_last;
  std::vector<ObjectId> m_changed;
  std::uint64_t m_revision = 0, m_committed = 0;
};

}  // namespace trivet::edit
