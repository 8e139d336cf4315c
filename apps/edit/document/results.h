// Conversion of operation results to messages. Private.
#pragma once

#include <optional>

#include "apps/edit/document/message.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// "stopped by \"cup\"", "at its limit"; empty: it went as far as it was to.
std::string why_it_ended(const Operation& operation, const OperationResult& result);

/// Message for a result; nullopt: done as requested.
/// @param clearance  metres, used by the operation; 0: the default.
std::optional<Message> message_of(const Scene& scene, const Operation& operation,
                                  const OperationResult& result, double clearance);

}  // namespace trivet::edit
