// Bytes of each file format. Little-endian hosts only, as the binary formats are.
#pragma once

#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "core/io/export.h"
#include "core/io/gltf/document.h"

namespace trivet {

static_assert(std::endian::native == std::endian::little);

/// Appends the bytes of a value in memory order.
template <class T>
void append_bytes(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// glTF 2.0: a node per object; below it the model's own nodes, else a mesh with a primitive per
/// material.
/// @throws Error (BadInput): extras that are not JSON, poses beyond float32.
GltfDocument gltf_document(const ExportScene& scene);
GltfJson material_json(const Material& material);

/// World coordinates relative to the scene's origin, z up: the float32 of exported_positions(),
/// nine significant digits.
struct ObjText {
  std::string obj, mtl;
};
/// Textures of one object in OBJ and MTL.
struct ObjTextures {
  std::span<const std::array<Eigen::Vector2f, 3>> coordinates;  // #F x 3, v up; empty: none
  std::vector<std::string> files;  // of the base colours, by material; empty: none
};
/// `mtl_name` is the file name of the material library in the OBJ.
/// @param textures  of the objects, in their order; objects beyond its end have none.
ObjText obj_text(const ExportScene& scene, const std::string& mtl_name,
                 const std::vector<ObjTextures>& textures = {});

/// World coordinates relative to the scene's origin, z up, binary little endian; one mesh, geometry
/// only.
std::string ply_bytes(const ExportScene& scene);

/// World coordinates relative to the scene's origin, z up, binary; geometry only.
std::string stl_bytes(const ExportScene& scene);

}  // namespace trivet
