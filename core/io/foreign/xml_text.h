// XML files as trees whose elements know the bytes where they stand, so that numbers can be changed
// in place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trivet {

/// Limits for XML of others: of all files of a scene together.
struct XmlLimits {
  std::uintmax_t max_bytes = std::uintmax_t{256} << 20;
  size_t max_elements = 4'000'000;
  int max_depth = 256;
};

/// A file as it was read.
struct XmlFile {
  std::string path;
  std::string bytes;
  size_t num_elements = 0;
};

struct XmlNode {
  std::string tag;                                              // without a namespace's prefix
  std::vector<std::pair<std::string, std::string>> attributes;  // in their order
  std::vector<XmlNode> children;
  std::string text;    // all character data directly inside
  size_t file = 0;     // into the files of the document
  size_t begin = 0;    // byte of the start tag's '<'
  size_t content = 0;  // byte behind the start tag's '>'
  size_t end = 0;      // byte of the end tag's '<'; of an empty element: `content`
  size_t line = 0;     // from 1

  /// Null: it has none.
  const std::string* find(std::string_view attribute) const;
  /// First child of that tag; null: none.
  const XmlNode* child(std::string_view name) const;
};

/// Reads one file into a tree.
/// @param index  the number that its elements get as `file`.
/// @throws Error (BadInput) naming the file and the line: missing, no regular file, not
///   well formed, beyond the limits together with `files`, entities of its own, an encoding other
///   than UTF-8.
XmlNode read_xml_tree(const std::string& path, size_t index, const XmlLimits& limits,
                      std::vector<XmlFile>& files);

}  // namespace trivet
