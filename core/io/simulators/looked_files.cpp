#include "core/io/simulators/looked_files.h"

#include <map>

#include "core/base/hash.h"

namespace trivet {
namespace {

/// Lines of vertices or texture coordinates, each of them once.
class Numbered {
 public:
  /// Its number, from 1.
  template <class Key, class Write>
  size_t number(std::map<Key, size_t>& known, const Key& key, const Write& write) {
    const auto [it, is_new] = known.try_emplace(key, known.size() + 1);
    if (is_new) write(m_text);
    return it->second;
  }
  const std::string& text() const { return m_text; }

 private:
  std::string m_text;
};

class LookedObj {
 public:
  LookedObj(const SimulationModel& model, const std::vector<std::string>& images)
      : m_model(model),
        m_images(images),
        m_positions(exported_positions({model.name, model.model, model.file_from_object, ""})) {}

  void add(const MaterialFaces& group) {
    const std::string name = "material" + std::to_string(group.material);
    const auto material = static_cast<size_t>(group.material);
    append_mtl(m_mtl, name, m_model.look->materials[material]);
    if (!m_images[material].empty()) m_mtl += "map_Kd " + m_images[material] + "\n";
    m_faces += "usemtl " + name + "\n";
    for (const Index f : group.faces) add_face(static_cast<size_t>(f));
  }

  ObjText text(const std::string& mtl_name) const {
    return {"# Trivet: metres, z up\nmtllib " + mtl_name + "\no " + m_model.name + "\n" +
                m_vertices.text() + m_coordinates.text() + m_faces,
            "# Trivet\n" + m_mtl};
  }

 private:
  void add_face(size_t f) {
    m_faces += 'f';
    for (size_t k = 0; k < 3; ++k) {
      const Index v = m_model.model->mesh.triangles[f][k];
      const Eigen::Vector2f uv = m_model.look->coordinates[f][k];
      m_faces += ' ' + std::to_string(vertex(v)) + '/' + std::to_string(coordinate(uv));
    }
    m_faces += '\n';
  }
  size_t vertex(Index v) {
    return m_vertices.number(m_known_vertices, v, [&](std::string& out) {
      const Eigen::Vector3f& p = m_positions[static_cast<size_t>(v)];
      append_obj_line(out, "v", {p.x(), p.y(), p.z()});
    });
  }
  size_t coordinate(const Eigen::Vector2f& uv) {
    return m_coordinates.number(m_known_coordinates, std::pair(uv.x(), uv.y()),
                                [&](std::string& out) {
                                  append_obj_line(out, "vt", {uv.x(), uv.y()});
                                });
  }

  const SimulationModel& m_model;
  const std::vector<std::string>& m_images;
  std::vector<Eigen::Vector3f> m_positions;
  std::map<Index, size_t> m_known_vertices;
  std::map<std::pair<float, float>, size_t> m_known_coordinates;
  Numbered m_vertices, m_coordinates;
  std::string m_faces, m_mtl;
};

}  // namespace

ImageFiles::ImageFiles(const SimulationScene& scene) {
  for (const SimulationModel& model : scene.models) {
    m_names.emplace_back();
    if (!model.look) continue;
    for (const std::string& bytes : model.look->images) {
      std::string name;
      if (!bytes.empty())
        name = model.name + "_t" + std::to_string(m_names.back().size()) + "_" +
               Hash().add(bytes).text() + ".png";
      m_names.back().push_back(name);
      if (!bytes.empty()) m_files.push_back({name, bytes});
    }
  }
}

std::vector<MaterialFaces> faces_of_look(const SimulationLook& look) {
  std::vector<MaterialFaces> out(look.materials.size());
  for (size_t i = 0; i < out.size(); ++i) out[i].material = static_cast<Index>(i);
  for (size_t f = 0; f < look.face_material.size(); ++f)
    out[static_cast<size_t>(look.face_material[f])].faces.push_back(static_cast<Index>(f));
  std::erase_if(out, [](const MaterialFaces& group) { return group.faces.empty(); });
  return out;
}

ObjText looked_obj(const SimulationModel& model, const std::vector<MaterialFaces>& groups,
                   const std::vector<std::string>& images, const std::string& mtl_name) {
  LookedObj out(model, images);
  for (const MaterialFaces& group : groups) out.add(group);
  return out.text(mtl_name);
}

}  // namespace trivet
