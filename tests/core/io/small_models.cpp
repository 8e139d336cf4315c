// One tetrahedron in every format: corners at the origin and at 1 on the axes, wound outwards.
#include <cstring>
#include <sstream>

#include "core/io/base64.h"
#include "core/io/io_testing.h"

namespace trivet::testing {
namespace {

constexpr float kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr std::uint16_t kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

template <class T>
void append(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string joined_faces(const char* face_end, const char* separator, int offset) {
  std::ostringstream out;
  for (const auto& face : kFaces) {
    for (int k = 0; k < 3; ++k) out << (k ? separator : "") << face[k] + offset;
    out << face_end;
  }
  return out.str();
}

std::string gltf_json(const std::string& nodes, const std::string& roots, const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + roots + R"(}],"nodes":)" +
         nodes + R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,)" +
         R"("material":0}]}],"materials":[{"name":"brass","pbrMetallicRoughness":)" +
         R"({"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0.75,"roughnessFactor":0.25}}],)" +
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)" +
         R"("min":[0,0,0],"max":[1,1,1]},{"bufferView":1,"componentType":5123,"count":12,)" +
         R"("type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},)" +
         R"({"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{)" + uri +
         R"("byteLength":72}]})";
}

std::string gltf_buffer() {
  std::string out;
  append(out, kCorners);
  append(out, kFaces);
  return out;
}

// A chunk of 3DS: id, length including this header, content.
std::string chunk(std::uint16_t id, const std::string& content) {
  std::string out;
  append(out, id);
  append(out, static_cast<std::uint32_t>(content.size() + 6));
  return out + content;
}

}  // namespace

std::string tetrahedron_obj() {
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf " + [] {
    std::string faces = joined_faces("\nf ", " ", 1);
    return faces.substr(0, faces.size() - 2);
  }();
}

std::string tetrahedron_ply() {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

std::string tetrahedron_stl() {
  std::ostringstream out;
  out << "solid tetrahedron\n";
  for (const auto& face : kFaces) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint16_t v : face)
      out << "vertex " << kCorners[v][0] << " " << kCorners[v][1] << " " << kCorners[v][2] << "\n";
    out << "endloop\nendfacet\n";
  }
  out << "endsolid tetrahedron\n";
  return out.str();
}

std::string tetrahedron_stl_binary() {
  std::string out(80, '\0');
  append(out, std::uint32_t{4});
  for (const auto& face : kFaces) {
    out.append(12, '\0');
    for (const std::uint16_t v : face) append(out, kCorners[v]);
    out.append(2, '\0');
  }
  return out;
}

std::string tetrahedron_dae(const std::string& up_axis, const std::string& unit) {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" +
         unit + up_axis + R"(</asset>
<library_effects><effect id="paint-fx"><profile_COMMON><technique sid="common"><lambert>
<diffuse><color>0.5 0.5 0.5 1</color></diffuse></lambert></technique></profile_COMMON></effect>
</library_effects>
<library_materials><material id="paint" name="paint"><instance_effect url="#paint-fx"/></material>
</library_materials>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4" material="m"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         joined_faces(" ", " ", 0) + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="n"><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="m" target="#paint"/>
</technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

std::string tetrahedron_fbx(int up_axis, double centimetres) {
  std::ostringstream faces;
  for (const auto& face : kFaces)  // the last corner of a polygon is stored inverted
    faces << (&face == kFaces ? "" : ",") << face[0] << "," << face[1] << "," << ~face[2];
  std::ostringstream out;
  out << R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",)"
      << up_axis << R"(
		P: "UpAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",)"
      << centimetres << R"(
	}
}
Objects:  {
	Geometry: 1001, "Geometry::g", "Mesh" {
		Vertices: *12 {
			a: 0,0,0,1,0,0,0,1,0,0,0,1
		}
		PolygonVertexIndex: *12 {
			a: )"
      << faces.str() << R"(
		}
		GeometryVersion: 124
	}
	Model: 1002, "Model::n", "Mesh" {
		Version: 232
	}
}
Connections:  {
	C: "OO",1002,0
	C: "OO",1001,1002
}
)";
  return out.str();
}

std::string tetrahedron_3ds() {
  std::string vertices, faces;
  append(vertices, std::uint16_t{4});
  append(vertices, kCorners);
  append(faces, std::uint16_t{4});
  for (const auto& face : kFaces) {
    append(faces, face);
    append(faces, std::uint16_t{7});  // all edges visible
  }
  const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  const std::string object = chunk(0x4000, std::string("tetra\0", 6) + mesh);
  return chunk(0x4D4D, chunk(0x3D3D, object));
}

std::string tetrahedron_gltf(const std::string& nodes, const std::string& roots) {
  return gltf_json(
      nodes, roots,
      R"("uri":"data:application/octet-stream;base64,)" + base64(gltf_buffer()) + R"(",)");
}

std::string tetrahedron_glb() {
  std::string json = gltf_json(R"([{"mesh":0,"name":"tetra"}])", "[0]", "");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string binary = gltf_buffer();
  std::string out = "glTF";
  append(out, std::uint32_t{2});
  append(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
  append(out, static_cast<std::uint32_t>(json.size()));
  out += "JSON" + json;
  append(out, static_cast<std::uint32_t>(binary.size()));
  out += std::string("BIN\0", 4) + binary;
  return out;
}

Model tetrahedron_model(const Vec3& offset) {
  std::vector<Triangle> triangles;
  for (const auto& face : kFaces) {
    Triangle t;
    for (int k = 0; k < 3; ++k)
      t[k] = offset + Vec3(kCorners[face[k]][0], kCorners[face[k]][1], kCorners[face[k]][2]);
    triangles.push_back(t);
  }
  Model model;
  model.path = "tetrahedron";
  model.mesh = weld(triangles);
  model.materials.emplace_back();
  model.face_material.assign(triangles.size(), 0);
  return model;
}

}  // namespace trivet::testing
