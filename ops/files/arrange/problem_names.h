// Private. Names in arrangement files.
#pragma once

#include <string>
#include <vector>

#include "ops/files/json/json_text.h"

namespace trivet {

/// Objects by their names, or by names with one * for any letters.
class ProblemNames {
 public:
  explicit ProblemNames(std::vector<std::string> names) : m_names(std::move(names)) {}

  std::string one(const JsonPlace& place) const;
  std::string one_or_floor(const JsonPlace& place) const;
  /// By a pattern; refuses one that names nothing.
  std::vector<std::string> matching(const JsonPlace& place) const;
  /// By a pattern, or a list of them: each object once, in that order.
  std::vector<std::string> listed(const JsonPlace& place) const;

 private:
  std::vector<std::string> m_names;
};

}  // namespace trivet
