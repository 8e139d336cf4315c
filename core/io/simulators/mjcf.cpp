// MuJoCo's MJCF: version 3, or the older 2.2.
#include <algorithm>
#include <iterator>
#include <set>

#include "core/io/simulators/floor_corners.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {
namespace {

using Element = tinyxml2::XMLElement;

constexpr double kCornerRadius = 1e-5;  // metres
constexpr size_t kContactsOfPair = 5, kRowsOfContact = 4, kMinContacts = 100, kMaxContacts = 2000;
/// Contacts by version: time constant and damping; stiffness near and beyond a depth.
constexpr const char *kSolref2 = "0.004 1", *kSolimp2 = "0.95 0.99 0.0001";
constexpr const char *kSolref3 = "0.004 3", *kSolimp3 = "0.995 0.9995 0.0001";
constexpr double kSag = 5e-7;  // metres, half of what weights press contacts together

std::string quaternion_text(const Rotation& r) { return numbers_text({r.w, r.x, r.y, r.z}); }

/// Stem of a file name, which also names the material and the image in MuJoCo.
std::string stem(const std::string& file) { return file.substr(0, file.rfind('.')); }

/// A mesh for MuJoCo is one of a size.
std::string mesh_name(const std::string& file, double scale) {
  return scale == 1 ? stem(file) : stem(file) + "_x" + number_text(scale);
}

class MjcfWriter {
 public:
  MjcfWriter(const SimulationScene& scene, const MeshFiles& meshes, const std::string& folder,
             const SimulationFileOptions& options)
      : m_scene(scene),
        m_meshes(meshes),
        m_folder(folder),
        m_version(options.mujoco),
        m_asleep(options.asleep) {
    m_frictions.insert(scene.floor_friction);
    for (const SimulationBody& body : scene.bodies) {
      m_frictions.insert(body.friction);
      m_corners.push_back(m_version < 3 && scene.floor && !body.fixed
                              ? floor_corners(scene.models[body.model], body.world_from_link)
                              : std::vector<Vec3>());
    }
  }

  std::string text() {
    m_document.InsertEndChild(m_document.NewComment(kMadeBy));
    Element* const root = add_child(&m_document, "mujoco", {{"model", m_scene.name}});
    add_child(root, "compiler",
              {{"angle", "radian"},
               {"meshdir", m_folder},
               {"texturedir", m_folder},
               {"inertiafromgeom", "false"}});
    if (m_version < 3) add_size(root);
    add_option(root);
    add_defaults(root);
    add_assets(root);
    Element* const world = add_child(root, "worldbody");
    add_child(world, "light", {{"pos", "0 0 3"}, {"dir", "0 0 -1"}, {"directional", "true"}});
    if (m_scene.floor)
      set_margin(add_child(world, "geom",
                           {{"name", "floor"},
                            {"class", "collision"},
                            {"type", "plane"},
                            {"group", "2"},
                            {"size", "0 0 1"},
                            {"conaffinity", "3"},
                            {"priority", priority_text(m_scene.floor_friction)},
                            {"friction", friction_text(m_scene.floor_friction)}}),
                 m_scene.floor_gap);
    for (size_t i = 0; i < m_scene.bodies.size(); ++i)
      add_corners(add_body(world, m_scene.bodies[i]), i);
    return xml_text(m_document);
  }

 private:
  // With a single contact point per pair of meshes, the default up to MuJoCo 3.7, boxes rock and
  // drift. Elliptic cones with stiff friction keep objects from creeping down slopes. In MuJoCo 2
  // that takes further iterations and shorter steps, which cost most of the time.
  void add_option(Element* root) const {
    Element* const option = add_child(root, "option",
                                      {{"timestep", m_version < 3 ? "0.001" : "0.002"},
                                       {"gravity", "0 0 " + number_text(-m_scene.gravity)},
                                       {"cone", "elliptic"},
                                       {"impratio", m_version < 3 ? "10" : "100"}});
    if (m_version < 3) {
      option->SetAttribute("noslip_iterations", "5");
    } else {  // the defaults are as coarse as Trivet's gaps
      option->SetAttribute("ccd_iterations", "100");
      option->SetAttribute("ccd_tolerance", "1e-09");
    }
    Element* const flag = add_child(option, "flag", {{"multiccd", "enable"}});
    if (m_asleep) flag->SetAttribute("sleep", "enable");
  }

  const char* solref() const { return m_version < 3 ? kSolref2 : kSolref3; }
  const char* solimp() const { return m_version < 3 ? kSolimp2 : kSolimp3; }

  // Bodies rest across gaps, by which they would fall before MuJoCo finds a contact. The margins of
  // two bodies add up to their gap, so that contacts bear from the first step.
  void set_margin(Element* geom, double gap) const {
    if (m_version >= 3) geom->SetAttribute("margin", number_text(gap / 2 + kSag).c_str());
  }

  void add_defaults(Element* root) {
    Element* const all = add_child(root, "default");
    // Contacts yield by micrometres under load instead of MuJoCo's default tenths of a millimetre.
    add_child(add_child(all, "default", {{"class", "collision"}}), "geom",
              {{"type", "mesh"},
               {"group", "3"},
               {"condim", "4"},
               {"solref", solref()},
               {"solimp", solimp()}});
    if (m_version < 3)
      add_child(add_child(all, "default", {{"class", "corner"}}), "geom",
                {{"type", "sphere"},
                 {"size", number_text(kCornerRadius)},
                 {"group", "3"},
                 {"contype", "2"},
                 {"conaffinity", "0"},
                 {"condim", "4"},
                 {"solref", solref()},
                 {"solimp", solimp()}});
    add_child(add_child(all, "default", {{"class", "visual"}}), "geom",
              {{"type", "mesh"}, {"group", "2"}, {"contype", "0"}, {"conaffinity", "0"}});
  }

  void add_assets(Element* root) {
    Element* const assets = add_child(root, "asset");
    std::set<std::string> known, materials;  // models may share pieces
    const auto add_mesh = [&](const std::string& file, double scale) {
      const std::string name = mesh_name(file, scale);
      if (!known.insert(name).second) return;
      Element* const mesh = add_child(assets, "mesh", {{"name", name}, {"file", file}});
      if (scale != 1) mesh->SetAttribute("scale", numbers_text({scale, scale, scale}).c_str());
      // MuJoCo 3 refuses solids without volume, as open meshes are; inertias are stated by bodies.
      if (m_version >= 3) mesh->SetAttribute("inertia", "shell");
    };
    for (size_t i = 0; i < m_scene.models.size(); ++i) {
      const ModelFiles& files = m_meshes.of_model(i);
      for (const VisualMesh& visual : files.visuals) {
        add_mesh(visual.file, files.scale);
        if (materials.insert(visual.file).second) add_material(assets, visual);
      }
      for (const std::string& part : files.parts) add_mesh(part, files.scale);
    }
  }

  void add_material(Element* assets, const VisualMesh& visual) {
    const Material& m = visual.material;
    Element* const material = add_child(
        assets, "material",
        {{"name", stem(visual.file)},
         {"rgba",
          numbers_text({m.base_colour[0], m.base_colour[1], m.base_colour[2], m.base_colour[3]})},
         {"shininess", number_text(1 - m.roughness)}});
    if (visual.image.empty()) return;
    material->SetAttribute("texture", stem(visual.image).c_str());
    if (m_images.insert(visual.image).second)
      add_child(assets, "texture",
                {{"name", stem(visual.image)}, {"type", "2d"}, {"file", visual.image}});
  }

  // MuJoCo 2 drops contacts beyond its buffer, whose default does not know the parts. Its memory
  // grows with the square.
  void add_size(Element* root) const {
    size_t contacts = kContactsOfPair * m_scene.num_near_parts;
    for (const std::vector<Vec3>& corners : m_corners) contacts += corners.size();
    contacts = std::clamp(contacts, kMinContacts, kMaxContacts);
    add_child(root, "size",
              {{"njmax", std::to_string(kRowsOfContact * contacts)},
               {"nconmax", std::to_string(contacts)}});
  }

  // The geom with the higher priority gives the friction: here the smaller one.
  std::string priority_text(double friction) const {
    return std::to_string(std::distance(m_frictions.upper_bound(friction), m_frictions.end()));
  }

  static std::string friction_text(double sliding) {
    return number_text(sliding) +
           " 0.005 0.0001";  // metres: MuJoCo's default torsional and rolling friction
  }

  Element* add_body(Element* world, const SimulationBody& body) {
    const Pose& pose = body.world_from_link;
    Element* const element = add_child(world, "body",
                                       {{"name", body.file_name},
                                        {"pos", vector_text(pose.translation)},
                                        {"quat", quaternion_text(pose.rotation)}});
    if (!body.fixed) add_child(element, "freejoint", {{"name", body.file_name}});
    if (!body.fixed && m_asleep) element->SetAttribute("sleep", "init");
    const Mat3& i = body.inertia;
    add_child(
        element, "inertial",
        {{"pos", vector_text(body.centre)},
         {"mass", number_text(body.mass)},
         {"fullinertia", numbers_text({i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)})}});
    const ModelFiles& files = m_meshes.of_model(body.model);
    for (const VisualMesh& visual : files.visuals)
      add_child(element, "geom",
                {{"class", "visual"},
                 {"mesh", mesh_name(visual.file, files.scale)},
                 {"material", stem(visual.file)}});
    for (const std::string& part : files.parts)
      set_margin(add_child(element, "geom",
                           {{"class", "collision"},
                            {"mesh", mesh_name(part, files.scale)},
                            {"priority", priority_text(body.friction)},
                            {"friction", friction_text(body.friction)}}),
                 body.gap);
    return element;
  }

  // MuJoCo 2 finds three contacts of a mesh on a plane, not always the same: what lies flat would
  // rattle and creep. Spheres that only the floor sees hold it at all corners.
  void add_corners(Element* element, size_t index) const {
    const SimulationBody& body = m_scene.bodies[index];
    const Pose& pose = body.world_from_link;
    for (const Vec3& corner : m_corners[index]) {
      const Vec3 centre = corner + Vec3(0, 0, kCornerRadius) - pose.translation;
      add_child(element, "geom",
                {{"class", "corner"},
                 {"pos", vector_text(pose.rotation.matrix().transpose() * centre)},
                 {"priority", priority_text(body.friction)},
                 {"friction", friction_text(body.friction)}});
    }
  }

  const SimulationScene& m_scene;
  const MeshFiles& m_meshes;
  const std::string m_folder;
  const int m_version;
  const bool m_asleep;
  std::set<double> m_frictions;
  std::set<std::string> m_images;            // that are assets already
  std::vector<std::vector<Vec3>> m_corners;  // of the bodies, see floor_corners()
  tinyxml2::XMLDocument m_document;
};

}  // namespace

SimulationText write_mjcf(const SimulationScene& scene, const std::string& folder,
                          const SimulationFileOptions& options) {
  const MeshFiles meshes(scene, true);
  return {meshes.files(), MjcfWriter(scene, meshes, folder, options).text()};
}

}  // namespace trivet
