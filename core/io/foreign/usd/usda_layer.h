// Layers of USD as text: prims with their properties as they are written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/foreign/xml_text.h"

namespace trivet {

/// A value without its brackets: numbers and words, each in their order.
struct UsdaValue {
  enum class Kind { Text, Word, Asset, Path, Key };
  std::vector<double> numbers;
  std::vector<std::pair<Kind, std::string>> words;
  bool blocks = false;  // None: weaker values do not count

  /// First word of that kind; null: none.
  const std::string* first(Kind kind) const;
};

/// A property, or an entry of metadata.
struct UsdaEntry {
  std::string name;  // with a suffix: "x.timeSamples"
  std::string type;  // of attributes: "double3"; of relationships "rel"
  std::string op;    // "prepend", "append", "add", "delete", "reorder", or nothing
  UsdaValue value;
  bool has_value = false;
  size_t line = 0;
};

/// A prim as one layer has it.
struct UsdaSpec {
  enum class Specifier { Def, Over, Class } specifier = Specifier::Def;
  std::string type, name;
  std::vector<UsdaEntry> metadata, properties;
  std::vector<UsdaSpec> children;
  std::vector<UsdaSpec> variants;  // named "set=variant"
  std::vector<size_t> by_name;     // children
  size_t line = 0;

  /// Null: it has none of that name.
  const UsdaSpec* child(std::string_view its_name) const;
};

struct UsdaLayer {
  std::string path;
  UsdaSpec root;  // its metadata are the layer's, its children the prims
  std::uintmax_t num_bytes = 0;
  size_t num_elements = 0;
};

/// The last of several entries of that name; null: none.
const UsdaEntry* find_entry(const std::vector<UsdaEntry>& entries, std::string_view name);

/// Reads one layer. @param limits  what is left of them.
/// @throws Error (BadInput) naming the file and the line: missing, binary, not well formed, beyond
///   the limits.
UsdaLayer read_usda_layer(const std::string& path, const XmlLimits& limits);

}  // namespace trivet
