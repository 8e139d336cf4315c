#include "ops/operations/operations.h"

#include <type_traits>
#include <utility>

#include "ops/operations/table.h"

namespace trivet {
namespace {

template <size_t... kIndex>
std::vector<Operation> kinds(std::index_sequence<kIndex...>) {
  return {Operation(std::in_place_index<kIndex>)...};
}

}  // namespace

const char* op_name(const Operation& operation) {
  const OperationTable& table = table_of(operation);
  return table.forms[table.form_of(data_of(operation))].op;
}

const std::string& object_name(const Operation& operation) {
  return std::visit([](const auto& o) -> const std::string& { return o.object; }, operation);
}

const OperationTable& table_of(const Operation& operation) {
  return std::visit(
      [](const auto& o) -> const OperationTable& { return table<std::decay_t<decltype(o)>>(); },
      operation);
}

void* data_of(Operation& operation) {
  return std::visit([](auto& o) -> void* { return &o; }, operation);
}

const void* data_of(const Operation& operation) {
  return std::visit([](const auto& o) -> const void* { return &o; }, operation);
}

const std::vector<Operation>& all_kinds() {
  static const std::vector<Operation> all =
      kinds(std::make_index_sequence<std::variant_size_v<Operation>>());
  return all;
}

}  // namespace trivet
