// A textured model as files, small enough to know every texel.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/image.h"
#include "core/io/base64.h"
#include "core/picture/png.h"

namespace trivet::testing {

// Red, green, blue and see-through white, from above left.
inline std::string four_colours_png() {
  return encode_png({2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0}});
}

template <class T>
void append_numbers(std::string& out, std::initializer_list<T> values) {
  for (const T value : values) out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A unit square in z = 0 of two triangles, its corners coloured by their positions; u to the
/// right, v down, as the image lies on it.
inline nlohmann::ordered_json square_json(const std::string& image = "c.png") {
  std::string buffer;
  append_numbers<float>(buffer, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  append_numbers<float>(buffer, {0, 1, 1, 1, 1, 0, 0, 0});
  append_numbers<std::uint16_t>(buffer, {0, 1, 2, 0, 2, 3});
  nlohmann::ordered_json json =
      nlohmann::ordered_json::parse(R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,
      "material":0}]}],
    "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
    "textures":[{"source":0}],
    "accessors":[
      {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
      {"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},
      {"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},
      {"buffer":0,"byteOffset":48,"byteLength":32},{"buffer":0,"byteOffset":80,"byteLength":12}]})");
  json["images"] = nlohmann::ordered_json::array({{{"uri", image}}});
  json["buffers"] = nlohmann::ordered_json::array(
      {{{"byteLength", buffer.size()},
        {"uri", "data:application/octet-stream;base64," + base64(buffer)}}});
  return json;
}

}  // namespace trivet::testing
