// The operations' implementations; everybody else calls perform() of operation.h.
#pragma once

#include "ops/operation.h"

namespace trivet {

// The whole operation; when it is refused, what it changed is for perform() to take back.
OperationResult perform_put(Scene& scene, ObjectId id, const PutOperation& o,
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
