// Private. Names in arrangement files.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ops/files/json/text.h"

namespace trivet {

/// Objects by their names, or by names with one * for any letters.
class ProblemNames {
 public:
  /// Accepts every name, and patterns as names: of problems whose scene is not there yet.
  ProblemNames() = default;
  explicit ProblemNames(std::vector<std::string> names) : m_names(std::move(names)) {}

  /// From now on patterns of subjects() are about these, if they fit any.
  void set_things(std::vector<std::string> things) { m_things = std::move(things); }

  /// Surfaces of objects, by names of their own.
  using Surfaces = std::map<std::string, int>;
  void set_surfaces(std::map<std::string, Surfaces> surfaces) { m_surfaces = std::move(surfaces); }
  /// Surfaces of this support; empty: it has none with names.
  const Surfaces& surfaces(const std::string& support) const;

  std::string one(const JsonPlace& place) const;
  std::string one_or_floor(const JsonPlace& place) const;
  /// By a pattern; refuses one that names nothing.
  std::vector<std::string> matching(const JsonPlace& place) const;
  std::vector<std::string> matching(const std::string& pattern, const JsonPlace& place) const;
  /// By a pattern, or a list of them: each object once, in that order.
  std::vector<std::string> listed(const JsonPlace& place) const;
  /// Subjects of a relation: by a pattern the things to arrange, else objects; but for `other`.
  std::vector<std::string> subjects(const JsonPlace& place, const std::string& other) const;

 private:
  bool knows(const std::string& name) const;

  std::optional<std::vector<std::string>> m_names;
  std::vector<std::string> m_things;
  std::map<std::string, Surfaces> m_surfaces;  // by names, or patterns of them
};

}  // namespace trivet
