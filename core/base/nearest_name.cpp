#include "core/base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace trivet {
namespace {

constexpr size_t kLongest = 100;  // longer ones are told apart by their beginnings

std::string in_lower_case(const std::string& text) {
  std::string out = text.substr(0, kLongest);
  for (char& c : out)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

// [Levenshtein 1966], by rows [Wagner 1974].
size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& names) {
  const std::string wanted = in_lower_case(word);
  const std::string* nearest = nullptr;
  size_t least = 0;
  for (const std::string& name : names) {
    const std::string there = in_lower_case(name);
    const size_t distance = there == wanted ? 0 : edit_distance(wanted, there);
    const bool near = 3 * distance <= std::max(wanted.size(), there.size());
    if (!near || (nearest && distance >= least)) continue;
    nearest = &name;
    least = distance;
  }
  return nearest ? *nearest : "";
}

Sentence did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(word, names);
  return nearest.empty() ? Sentence() : say("; did you mean \"%1\"?", nearest);
}

}  // namespace trivet
