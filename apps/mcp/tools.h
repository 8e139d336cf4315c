// The tools: one table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/mcp/tool_schemas.h"
#include "apps/mcp/workplace.h"

namespace trivet::mcp {

struct Tool {
  std::string name, description;
  Json schema;      // of its arguments
  bool only_tells;  // it changes nothing
  std::function<Answer(Workplace&, const JsonPlace& arguments)> call;
};

/// @param saves  with `save`.
std::vector<Tool> make_tools(const SchemaTexts& texts, bool saves);
/// The answer to "tools/list".
Json tools_json(const std::vector<Tool>& tools);

}  // namespace trivet::mcp
