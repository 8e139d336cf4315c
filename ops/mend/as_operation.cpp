// MEND and SETTLE as operations: planned on a copy of the scene, then committed as poses.
#include "core/scene/transaction.h"
#include "ops/base/outcome.h"
#include "ops/base/stopwatch.h"
#include "ops/check/check.h"
#include "ops/mend/mend.h"
#include "ops/operations/repair.h"

namespace trivet {
namespace {

MendOptions repair_options_of(const RepairOperation& o, const SettleOptions& settle,
                              const RunContext& context) {
  MendOptions out;
  out.settle = settle;
  out.context = context;
  out.only = o.only;
  out.most_lift = o.lift;
  out.tolerance = o.tolerance;
  out.seconds = context.time_budget_s;
  return out;
}

MendedScene repaired_copy(Scene scene, bool mends, const MendOptions& options) {
  MendedScene out;
  if (mends)
    out = mend_scene(scene, options);
  else
    static_cast<SettledScene&>(out) = settle_scene(scene, options);
  return out;
}

void place_repaired(Transaction& transaction, const SettledScene& repaired,
                    const SettleOptions& settle) {
  for (const SettledObject& o : repaired.moved) {
    transaction.clear_contacts(o.id);
    transaction.edit(o.id, [&](Object& object) { object.pose = o.to; });
  }
  update_contacts(transaction, transaction.touched(), settle.clearance, settle);
}

}  // namespace

OperationResult repair(Transaction& transaction, const RepairOperation& o,
                       const SettleOptions& settle, const RunContext& context) {
  const Stopwatch stopwatch;
  for (const std::string& name : o.only)
    if (!transaction.scene().find(name)) return refused(unknown_object(transaction.scene(), name));
  auto repaired = std::make_shared<const MendedScene>(
      repaired_copy(transaction.scene(), o.mends, repair_options_of(o, settle, context)));
  OperationResult out;
  out.end = OperationResult::End::Done;
  if (context.cancel && *context.cancel) {
    Refusal why{Refusal::Cause::Cancelled, {{"", std::nullopt}}};
    why.detail = o.mends ? "mend" : "settle";
    out.refuse(std::move(why));
    out.status = OperationResult::Status::Cancelled;
  } else {
    place_repaired(transaction, *repaired, settle);
    out.repaired = std::move(repaired);
  }
  out.milliseconds = stopwatch.milliseconds();
  return out;
}

}  // namespace trivet
