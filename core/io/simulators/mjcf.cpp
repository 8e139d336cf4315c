// MuJoCo's MJCF: version 3, or the older 2.2.
#include <algorithm>
#include <iterator>
#include <set>

#include "core/io/simulators/floor_corners.h"
#include "core/io/simulators/joints.h"
#include "core/io/simulators/mujoco_contacts.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {
namespace {

using Element = tinyxml2::XMLElement;

constexpr double kCornerRadius = 1e-5;  // metres
constexpr size_t kContactsOfPair = 5, kRowsOfContact = 4, kMinContacts = 100, kMaxContacts = 2000;
/// Contacts of version 2, as kMujocoSolref and kMujocoSolimp are those of 3.
constexpr const char *kSolref2 = "0.004 1", *kSolimp2 = "0.95 0.99 0.0001";
/// The same where a body carries more than kHeavyLoad of its own masses. Contacts are as stiff as
/// the lighter of two bodies asks, so that heavy ones sink into what carries them, and slip. The
/// first micrometre is soft: contacts that bear on less would be lost by the least motion.
constexpr const char *kSolrefHeavy = "0.002 3", *kSolimpHeavy = "0.9 0.9999 0.000002";
constexpr double kHeavyLoad = 20;
constexpr double kSag = 5e-7;  // metres, half of what weights press contacts together
/// The same of limits of joints and of their friction.
constexpr const char *kSolrefJoint = "0.004 1", *kSolimpLimit = "0.95 0.99 0.0001",
                     *kSolimpFriction = "0.9999 0.9999 0.001";

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
        m_joints(scene),
        m_meshes(meshes),
        m_folder(folder),
        m_version(options.mujoco),
        m_is_heavy(options.mujoco >= 3 && scene.heaviest_load > kHeavyLoad),
        m_asleep(options.asleep) {
    m_frictions.insert(scene.floor_friction);
    for (const SimulationBody& body : scene.bodies) {
      m_frictions.insert(body.friction);
      m_corners.push_back(scene.floor && !body.fixed ? corners_of(body) : std::vector<Vec3>());
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
      if (!m_joints.of(i) || !m_joints.of(i)->parent)
        add_tree(world, i, m_scene.bodies[i].world_from_link);
    add_excludes(root);
    add_keyframe(root);
    return xml_text(m_document);
  }

 private:
  // With a single contact point per pair of meshes, the default up to MuJoCo 3.7, boxes rock and
  // drift. Elliptic cones with stiff friction keep objects from creeping down slopes. In MuJoCo 2
  // that takes further iterations and shorter steps, which cost most of the time.
  void add_option(Element* root) const {
    Element* const option =
        add_child(root, "option",
                  {{"timestep", m_version < 3 || m_is_heavy ? "0.001" : "0.002"},
                   {"gravity", "0 0 " + number_text(-m_scene.gravity)},
                   {"cone", "elliptic"},
                   {"impratio", m_version < 3 ? "10" : "100"}});
    if (m_version < 3) {
      option->SetAttribute("noslip_iterations", "5");
    } else {  // the defaults are as coarse as Trivet's gaps
      option->SetAttribute("ccd_iterations", "100");
      option->SetAttribute("ccd_tolerance", "1e-09");
      // The solver's tolerance counts in parts of the mean inertia, too coarse for what is light.
      if (m_is_heavy) option->SetAttribute("tolerance", "1e-14");
    }
    Element* const flag = add_child(option, "flag", {{"multiccd", "enable"}});
    if (m_asleep) flag->SetAttribute("sleep", "enable");
  }

  const char* solref() const {
    return m_version < 3 ? kSolref2 : m_is_heavy ? kSolrefHeavy : kMujocoSolref;
  }
  const char* solimp() const {
    return m_version < 3 ? kSolimp2 : m_is_heavy ? kSolimpHeavy : kMujocoSolimp;
  }

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
               {"condim", std::to_string(kMujocoCondim)},
               {"solref", solref()},
               {"solimp", solimp()}});
    if (has_corners())
      add_child(add_child(all, "default", {{"class", "corner"}}), "geom",
                {{"type", "sphere"},
                 {"size", number_text(kCornerRadius)},
                 {"group", "3"},
                 {"contype", "2"},
                 {"conaffinity", "0"},
                 {"condim", std::to_string(kMujocoCondim)},
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

  // The body, and in it those that hang in it.
  void add_tree(Element* parent, size_t index, const Pose& in_parent) {
    Element* const element = add_body(parent, index, in_parent);
    add_corners(element, index);
    const Pose& pose = m_scene.bodies[index].world_from_link;
    for (const SimulationJoint* joint : m_joints.below(index))
      add_tree(element, joint->child,
               relative_pose(pose, m_scene.bodies[joint->child].world_from_link));
  }

  // Positions of all joints as they are laid out, for programs that reset scenes by it.
  void add_keyframe(Element* root) const {
    if (m_positions.empty()) return;
    std::string text;
    for (const double value : m_positions) text += (text.empty() ? "" : " ") + number_text(value);
    add_child(add_child(root, "keyframe"), "key", {{"name", "laid_out"}, {"qpos", text}});
  }

  void add_free_joint(Element* element, const SimulationBody& body) {
    add_child(element, "freejoint", {{"name", body.file_name}});
    const Pose& pose = body.world_from_link;
    const Vec3& p = pose.translation;
    const Rotation& q = pose.rotation;
    m_positions.insert(m_positions.end(), {p.x(), p.y(), p.z(), q.w, q.x, q.y, q.z});
    if (m_asleep) element->SetAttribute("sleep", "init");
  }

  // The bodies are where `ref` has the joint.
  void add_joint(Element* body, const SimulationJoint& joint) {
    if (joint.kind == SimulationJoint::Kind::Fixed) return;
    m_positions.push_back(joint.value);
    const bool turns = joint.kind == SimulationJoint::Kind::Hinge;
    Element* const element = add_child(body, "joint",
                                       {{"name", joint.file_name},
                                        {"type", turns ? "hinge" : "slide"},
                                        {"pos", vector_text(joint.anchor)},
                                        {"axis", vector_text(joint.axis)},
                                        {"ref", number_text(joint.value)}});
    if (joint.friction > 0) {
      element->SetAttribute("frictionloss", number_text(joint.friction).c_str());
      element->SetAttribute("solreffriction", kSolrefJoint);  // else it creeps by degrees a second
      element->SetAttribute("solimpfriction", kSolimpFriction);
    }
    if (joint.lower == -kInfinity && joint.upper == kInfinity) return;
    element->SetAttribute("limited", "true");
    element->SetAttribute("solreflimit", kSolrefJoint);
    element->SetAttribute("solimplimit", kSolimpLimit);
    element->SetAttribute(
        "range", numbers_text({finite_limit(joint.lower), finite_limit(joint.upper)}).c_str());
  }

  // MuJoCo keeps a link off what it hangs in, unless that is fixed in the world.
  void add_excludes(Element* root) const {
    Element* contact = nullptr;
    for (const SimulationJoint& joint : m_scene.joints)
      for (const size_t other : joint.apart) {
        if (!contact) contact = add_child(root, "contact");
        add_child(contact, "exclude",
                  {{"body1", m_scene.bodies[other].file_name},
                   {"body2", m_scene.bodies[joint.child].file_name}});
      }
  }

  Element* add_body(Element* parent, size_t index, const Pose& pose) {
    const SimulationBody& body = m_scene.bodies[index];
    Element* const element = add_child(parent, "body",
                                       {{"name", body.file_name},
                                        {"pos", vector_text(pose.translation)},
                                        {"quat", quaternion_text(pose.rotation)}});
    if (!body.fixed) add_free_joint(element, body);
    if (const SimulationJoint* const joint = m_joints.of(index)) add_joint(element, *joint);
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
  // rattle and creep. MuJoCo 3 finds one of an edge if a face at its end is flatter than those
  // beside it, so that what stands on edges would rock. Spheres that only the floor sees hold the
  // corners.
  std::vector<Vec3> corners_of(const SimulationBody& body) const {
    const SimulationModel& model = m_scene.models[body.model];
    return m_version < 3 ? floor_corners(model, body.world_from_link)
                         : floor_edge_ends(model, body.world_from_link, body.gap + kSag);
  }
  bool has_corners() const {
    return std::any_of(m_corners.begin(), m_corners.end(),
                       [](const std::vector<Vec3>& corners) { return !corners.empty(); });
  }

  void add_corners(Element* element, size_t index) const {
    const SimulationBody& body = m_scene.bodies[index];
    const Pose& pose = body.world_from_link;
    for (const Vec3& corner : m_corners[index]) {
      const Vec3 centre = corner + Vec3(0, 0, kCornerRadius) - pose.translation;
      set_margin(add_child(element, "geom",
                           {{"class", "corner"},
                            {"pos", vector_text(pose.rotation.matrix().transpose() * centre)},
                            {"priority", priority_text(body.friction)},
                            {"friction", friction_text(body.friction)}}),
                 body.gap);
    }
  }

  const SimulationScene& m_scene;
  const JointsOfBodies m_joints;
  const MeshFiles& m_meshes;
  const std::string m_folder;
  const int m_version;
  const bool m_is_heavy;
  const bool m_asleep;
  std::vector<double> m_positions;  // of the joints, in the order of bodies
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
