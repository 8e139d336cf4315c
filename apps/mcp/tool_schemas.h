// Schemas of the arguments of tools, from the tables of operations.
#pragma once

#include <string>
#include <vector>

#include "apps/mcp/messages.h"

namespace trivet::mcp {

struct SchemaTexts {
  const char* layout = "{}";   // layout.schema.in.json
  const char* arrange = "{}";  // arrange.schema.in.json
};

/// An operation as a tool: all its forms together, without references.
struct OperationTool {
  std::string op, description;
  Json schema;
};

/// The operations of these names, in this order.
std::vector<OperationTool> operation_tools(const std::vector<std::string>& ops,
                                           const SchemaTexts& texts);

}  // namespace trivet::mcp
