// Results of operations as messages. Private.
#pragma once

#include <optional>

#include "apps/edit/document/message.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// What there is to say; nothing: it went as was asked for.
/// @param clearance  metres, that it was done with; 0: the default.
std::optional<Message> message_of(const Scene& scene, const Operation& operation,
                                  const OperationResult& result, double clearance);

}  // namespace trivet::edit
