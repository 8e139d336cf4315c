// Options of the command line for an operation, made of its table (ops/operations/table.h).
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "apps/trivet/common.h"
#include "ops/operations/operations.h"
#include "ops/operations/table.h"

namespace trivet::apps {

class OperationOptions {
 public:
  /// @param kind  any operation of the kind. @param op  its name in layouts: "unfix".
  /// @param without  keys that are no options of this verb.
  OperationOptions(CLI::App& app, const Operation& kind, std::string op,
                   const std::set<std::string>& without);
  ~OperationOptions();

  /// The operation that the parsed options ask for.
  /// @param start  of the kind; has what is no option of the verb.
  /// @throws Error (BadInput) naming the option, its value and what is accepted.
  Operation operation(Operation start) const;

 private:
  struct Option;

  void add(const Field& field, Operation sample);
  const Option* find(const std::string& key) const;
  size_t form() const;
  void refuse_others(size_t form) const;
  std::string way(size_t form) const;

  CLI::App& m_app;
  const OperationTable& m_table;
  Operation m_kind;
  std::string m_op;
  std::vector<std::unique_ptr<Option>> m_options;
};

/// Names of objects that the operation mentions and the scene does not have.
/// @throws Error (BadInput) naming the first. @param file  of the scene.
void check_objects(const Operation& operation, const Scene& scene, const std::string& file);

}  // namespace trivet::apps
