// Objects taken out of a scene and put back one after the other. Private.
#pragma once

#include <cassert>
#include <functional>
#include <map>
#include <memory>

#include "core/scene/transaction.h"
#include "ops/base/deadline.h"
#include "ops/base/outcome.h"
#include "ops/mend/intent.h"
#include "ops/mend/settle_free.h"
#include "ops/operations/put.h"

namespace trivet {

inline Sentence time_is_over() { return Sentence("the time is over"); }

class Rearrangement {
 public:
  /// Takes the objects out. The scene stays someone else's.
  Rearrangement(Scene& scene, const SettleSceneOptions& options, const Deadline& deadline,
                const std::vector<ObjectId>& ids);

  const Scene& scene() const { return m_scene; }
  const SettleSceneOptions& options() const { return m_options; }
  const Pose& given(ObjectId id) const { return m_given.at(id.index); }
  bool is_out_of_time() const { return m_deadline.is_over(); }

  /// Where it was, if it is free and at rest there.
  bool keep(ObjectId id) { return stand_still(id, given(id)); }
  /// The same of another pose. @param accept  asked of the object there; empty: always.
  bool stand_still(ObjectId id, const Pose& pose,
                   const std::function<bool(const Object&)>& accept = {});
  /// PUT from a start pose. @param tries  see PutOperation.
  OperationResult put(ObjectId id, const Pose& start, int tries = kTriesOfPut) {
    return put_in(m_scene, id, start, tries);
  }
  /// A PUT that was done and taken back.
  struct Trial {
    OperationResult result;
    std::shared_ptr<SceneChange> change;  // see redo(); null: refused
  };
  /// @param judge  sees the object where it was put.
  template <class Judge>
  Trial try_put(ObjectId id, const Pose& start, const Judge& judge, int tries = kTriesOfPut) {
    Transaction transaction(m_scene);
    Trial out{put_in(transaction, id, start, tries), nullptr};
    if (!out.result.ok()) return out;
    judge(m_scene.at(id));
    out.change = std::make_shared<SceneChange>();  // before the commit: then nothing may fail
    *out.change = transaction.commit();
    m_scene.exchange(*out.change);
    return out;
  }
  /// Does the trial again, without its cost. The scene is as it was before it.
  void redo(const Trial& trial) {
    assert(trial.change);
    m_scene.exchange(*trial.change);
  }
  /// These, where they stand, come to rest as a whole. @return those that do not.
  std::vector<ObjectId> rest_together(const std::vector<ObjectId>& ids);
  void give_up(ObjectId id, Sentence why) {
    if (is_out_of_time()) why = time_is_over();
    m_out.unable.push_back({id, m_scene.at(id).name, std::move(why)});
  }

  /// Objects that were given up stand where they were; what has moved, and how far.
  SettledScene finish();

 private:
  template <class Target>
  OperationResult put_in(Target& target, ObjectId id, const Pose& start, int tries);

  // One that takes long ends with the whole.
  RunContext context() const;

  Scene& m_scene;
  const SettleSceneOptions& m_options;
  const Deadline m_deadline;
  std::map<std::uint32_t, Pose> m_given;  // by slot, of all: some give way
  SettledScene m_out;
};

/// These stay where they are: the time was over before anything moved.
SettledScene left_as_they_are(const Scene& scene, const std::vector<ObjectId>& ids);

/// Objects that are elsewhere than they were given, in the scene's order. @param given  by slot.
std::vector<SettledObject> moved_since(const std::map<std::uint32_t, Pose>& given,
                                       const Scene& scene);

/// Objects among these that do not rest where they are: alone, or as a whole, by the rules. The
/// scene's contacts are those of its poses.
std::vector<ObjectId> not_at_rest(const Scene& scene, const SettleSceneOptions& options,
                                  const std::vector<ObjectId>& ids);

/// The lowest first.
std::vector<ObjectId> lowest_first(const Scene& scene, std::vector<ObjectId> ids);

/// Pose `then`, carried along by what moves `from` to `to`.
Pose carried_along(const Pose& from, const Pose& to, const Pose& then);

/// Supports that carry an object, by its contacts.
std::vector<Support> carriers_of(const Object& object);

/// Counts supports that were meant and those that are kept; names lost and new ones.
void compare_relations(const Scene& scene, const ObjectIntent& meant, MendedScene& out);

}  // namespace trivet
