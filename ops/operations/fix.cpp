#include "ops/operations/fix.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<FixOperation>() {
  using P = FixOperation;
  static const OperationTable rows =
      make_table<P>({{"fix",
                      "Fix an object: it never moves and supports any load",
                      {},
                      {},
                      [](const P& o) { return o.fixed; },
                      [](P& o) { o.fixed = true; }},
                     {"unfix",
                      "Unfix an object: it can be moved, with its loads",
                      {},
                      {},
                      [](const P& o) { return !o.fixed; },
                      [](P& o) { o.fixed = false; }}},
                    {});
  return rows;
}

OperationResult apply(Transaction& transaction, const FixOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_named(transaction, o.object);
  // An operation that changes nothing leaves no trace.
  if (scene.at(id).fixed == o.fixed) return done_result();
  // A link is held by its joint, not by being free.
  if (scene.at(id).joint) return refused(std::move(*refuse_in_joint(scene, id)));
  transaction.edit(id, [&](Object& object) {
    object.fixed = o.fixed;
    if (!o.fixed) object.flexible.reset();  // stiff from now on: it moves as one
  });
  if (!scene.at(id).placed) return done_result();
  const double clearance = clearance_near(scene, run.options, scene.world_box(id));
  // A fixed object is tested where it is, as it will not be moved out of trouble.
  if (o.fixed) {
    if (auto why = refuse_stand(scene, id, scene.at(id).pose, run.options))
      return refused(std::move(*why));
    stand_at(transaction, id, scene.at(id).pose, rest_rules(run.options, clearance));
    return done_result();
  }
  OperationResult result = done_result();
  // An object that may move again counts as stable until its contacts tell otherwise.
  transaction.edit(id, [](Object& object) { object.state = ObjectState::Stable; });
  rate_left_alone(transaction, id, rest_rules(run.options, clearance), result);
  return result;
}

}  // namespace trivet
