// A prim as all layers together have it.
#include <algorithm>

#include "core/io/foreign/usd/usda_stage.h"

namespace trivet {
namespace {

bool is_listed(const UsdaEntry& entry, std::string_view word) {
  return std::any_of(entry.value.words.begin(), entry.value.words.end(),
                     [&](const auto& w) { return w.second == word; });
}

}  // namespace

std::string UsdaMapping::mapped(const std::string& path) const {
  if (from.empty()) return path;
  const bool inside =
      path.starts_with(from) && (path.size() == from.size() || path[from.size()] == '/');
  return inside ? to + path.substr(from.size()) : "";
}

const UsdaEntry* UsdaPrim::find(std::string_view property) const {
  for (const UsdaOpinion& opinion : opinions)
    if (const UsdaEntry* const entry = find_entry(opinion.spec->properties, property))
      return entry->value.blocks ? nullptr : entry;
  return nullptr;
}

const UsdaEntry* UsdaPrim::metadata(std::string_view key) const {
  for (const UsdaOpinion& opinion : opinions)
    if (const UsdaEntry* const entry = find_entry(opinion.spec->metadata, key)) return entry;
  return nullptr;
}

bool UsdaPrim::has_api(std::string_view schema) const {
  for (const UsdaOpinion& opinion : opinions)
    for (const UsdaEntry& entry : opinion.spec->metadata) {
      if (entry.name != "apiSchemas") continue;
      if (is_listed(entry, schema)) return entry.op != "delete";
      // A list without an operation replaces the weaker ones.
      if (entry.op.empty()) return false;
    }
  return false;
}

std::vector<std::string> UsdaPrim::targets(std::string_view relationship) const {
  std::vector<std::string> out;
  for (const UsdaOpinion& opinion : opinions)
    for (const UsdaEntry& entry : opinion.spec->properties) {
      if (entry.name != relationship || !entry.has_value || entry.op == "delete") continue;
      for (const auto& [kind, word] : entry.value.words)
        if (std::string target = opinion.mapping->mapped(word); !target.empty())
          out.push_back(std::move(target));
      if (entry.op.empty()) return out;
    }
  return out;
}

}  // namespace trivet
