// Conversion of operation results to messages. Private.
#pragma once

#include <optional>

#include "apps/edit/document/message.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// Message for a result; nullopt: done as requested.
/// @param clearance  metres, used by the operation; 0: the default.
std::optional<Message> message_of(const Scene& scene, const Operation& operation,
                                  const OperationResult& result, double clearance);

}  // namespace trivet::edit
