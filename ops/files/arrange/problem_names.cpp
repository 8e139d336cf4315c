#include "ops/files/arrange/problem_names.h"

#include <algorithm>

#include "core/base/nearest_name.h"
#include "ops/files/arrange/section.h"

namespace trivet {

bool matches_name(const std::string& name, const std::string& pattern) {
  const size_t star = pattern.find('*');
  if (star == std::string::npos) return name == pattern;
  const std::string head = pattern.substr(0, star), tail = pattern.substr(star + 1);
  return name.size() >= head.size() + tail.size() && name.starts_with(head) && name.ends_with(tail);
}

const ProblemNames::Surfaces& ProblemNames::surfaces(const std::string& support) const {
  static const Surfaces none;
  for (const auto& [pattern, surfaces] : m_surfaces)
    if (matches_name(support, pattern)) return surfaces;
  return none;
}

bool ProblemNames::knows(const std::string& name) const {
  return !m_names || std::find(m_names->begin(), m_names->end(), name) != m_names->end();
}

std::string ProblemNames::one(const JsonPlace& place) const {
  std::string out = place.text();
  if (!knows(out)) place.refuse(say("the name of one of /objects%1", did_you_mean(out, *m_names)));
  return out;
}

std::string ProblemNames::one_or_floor(const JsonPlace& place) const {
  std::string out = place.text();
  if (out != "floor" && !knows(out))
    place.refuse(say("\"floor\" or the name of one of /objects%1", did_you_mean(out, *m_names)));
  return out;
}

std::vector<std::string> ProblemNames::matching(const JsonPlace& place) const {
  return matching(place.text(), place);
}

std::vector<std::string> ProblemNames::matching(const std::string& pattern,
                                                const JsonPlace& place) const {
  if (!m_names) return {pattern};
  std::vector<std::string> out;
  for (const std::string& name : *m_names)
    if (matches_name(name, pattern)) out.push_back(name);
  if (out.empty())
    place.refuse(say("the name of one of /objects, or one with * for any letters%1",
                     did_you_mean(pattern, *m_names)));
  return out;
}

std::vector<std::string> ProblemNames::listed(const JsonPlace& place) const {
  if (!place.value().is_array()) return matching(place);
  std::vector<std::string> out;
  for (const JsonPlace& item : place.items())
    for (const std::string& each : matching(item)) {
      if (std::find(out.begin(), out.end(), each) != out.end()) item.refuse("each object once");
      out.push_back(each);
    }
  if (out.empty()) place.refuse("at least one object");
  return out;
}

std::vector<std::string> ProblemNames::subjects(const JsonPlace& place,
                                                const std::string& other) const {
  const std::string pattern = place.text();
  if (pattern.find('*') == std::string::npos) return matching(place);
  std::vector<std::string> out;
  const auto collect = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names)
      if (name != other && matches_name(name, pattern)) out.push_back(name);
  };
  collect(m_things);
  return out.empty() ? matching(place) : out;
}

}  // namespace trivet
