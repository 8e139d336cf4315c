// Private to gpu: structs that C++ and shaders share, declared once, in text that is both.
#pragma once

#include <array>
#include <cstdint>

namespace trivet::glsl {

// GLSL's types, with the alignment that std430 gives them. No vec3: std430 aligns it to 16 bytes
// and lets a scalar use the last four.
using uint = std::uint32_t;
struct alignas(8) ivec2 {
  std::int32_t x, y;
};
struct alignas(16) vec4 {
  float x, y, z, w;
};

}  // namespace trivet::glsl

/// The struct Name in the current namespace, which sees those types, and its fields as GLSL text:
/// kNameFields. The bytes are those of a std430 block with these fields.
#define TRIVET_SHADER_STRUCT(Name, ...) \
  struct Name {                         \
    __VA_ARGS__                         \
  };                                    \
  inline constexpr const char* k##Name##Fields = #__VA_ARGS__
