// The operations' implementations; everybody else calls perform() of operation.h.
#pragma once

#include <functional>

#include "ops/move/moving_group.h"
#include "ops/operation.h"

namespace trivet {

// The whole operation; when it is refused, what it changed is for perform() to take back.
OperationResult perform_put(Scene& scene, ObjectId id, const PutOperation& o,
                            const SettleOptions& options);
/// Why a group that has settled may not stay there; empty: it may.
using EndCondition = std::function<std::string(const MovingGroup&)>;
/// A PUT from o.start. @param why_not  may be empty.
OperationResult put_from_start(Scene& scene, ObjectId id, const PutOperation& o,
                               const SettleOptions& options, const EndCondition& why_not);
/// A PUT that looks for its start: o.place is set.
OperationResult put_somewhere(Scene& scene, ObjectId id, const PutOperation& o,
                              const SettleOptions& options);
OperationResult perform_push(Scene& scene, ObjectId id, const PushOperation& o,
                             const SettleOptions& options);
OperationResult perform_turn(Scene& scene, ObjectId id, const TurnOperation& o,
                             const SettleOptions& options);
OperationResult perform_pick_up(Scene& scene, ObjectId id, const PickUpOperation& o,
                                const SettleOptions& options);
OperationResult perform_translate(Scene& scene, ObjectId id, const TranslateOperation& o,
                                  const SettleOptions& options);
OperationResult perform_rotate(Scene& scene, ObjectId id, const RotateOperation& o,
                               const SettleOptions& options);

}  // namespace trivet
