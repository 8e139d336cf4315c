// Headers of PLY files [Turk 1994].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivet {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a value.
size_t size_of(PlyType type);
/// Largest value of an integer type, by which colours are scaled; 1 for other types.
double full_scale(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { Text, LittleEndian, BigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  // of comments "TextureFile"
  size_t size = 0;                    // of the header: the data begins there

  std::int64_t num_items() const;
};

/// @param path  for messages. @throws Error (BadInput) naming the file and the line.
PlyHeader read_ply_header(const std::string& path, std::string_view bytes);

}  // namespace trivet
