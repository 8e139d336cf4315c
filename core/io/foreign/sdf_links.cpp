#include "core/io/foreign/sdf_links.h"

#include "core/base/bad_input.h"
#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/mjcf/settings.h"
#include "core/io/foreign/numbers.h"
#include "core/io/foreign/primitives.h"
#include "core/io/foreign/sdf_text.h"
#include "core/io/foreign/uri.h"

namespace trivet {
namespace {

constexpr std::uint32_t kAllBits = 0xffff;

class SdfCollision {
 public:
  SdfCollision(const XmlNode& node, const SdfMeshes& meshes, const std::vector<XmlFile>& files)
      : m_node(node), m_meshes(meshes), m_files(files) {}

  ContactBits bits() const {
    ContactBits bits;
    bits.type = bits.affinity = kAllBits;
    const XmlNode* const surface = m_node.child("surface");
    if (!surface) return bits;
    const XmlNode* const friction = surface->child("friction");
    if (const XmlNode* const ode = friction ? friction->child("ode") : nullptr)
      bits.friction = number(*ode, "mu", 1);
    if (const XmlNode* const contact = surface->child("contact"))
      bits.type = bits.affinity = bitmask(*contact);
    return bits;
  }

  // The +z axis of a plane is its normal.
  Rotation z_to_normal(const XmlNode& plane) const {
    const Vec3 normal = vec3(plane, "normal", Vec3::UnitZ());
    if (!(normal.norm() > 1e-14)) place(plane).refuse("normal", "", "a direction");
    return mjcf::z_to(normal);
  }

  double radius_of(const XmlNode& shape) const { return number(shape, "radius", 1); }

  // Empty: it is not read.
  Mesh mesh_of(const XmlNode& shape) const {
    if (shape.tag == "box") return box_mesh(0.5 * vec3(shape, "size", Vec3::Ones()));
    const double radius = radius_of(shape), half = number(shape, "length", 1) / 2;
    if (shape.tag == "sphere") return ball_mesh(radius);
    if (shape.tag == "ellipsoid") return ellipsoid_mesh(vec3(shape, "radii", Vec3::Ones()));
    if (shape.tag == "cylinder") return cylinder_mesh(radius, half);
    if (shape.tag == "capsule") return capsule_mesh(radius, half);
    return shape.tag == "mesh" && !shape.child("submesh") ? file_mesh(shape) : Mesh{};
  }

 private:
  XmlPlace place(const XmlNode& node) const { return {m_files, node}; }
  double number(const XmlNode& node, const char* child, double otherwise) const {
    return sdf_number(m_files, node, child, otherwise);
  }
  Vec3 vec3(const XmlNode& node, const char* child, const Vec3& otherwise) const {
    return sdf_vec3(m_files, node, child, otherwise);
  }

  std::uint32_t bitmask(const XmlNode& contact) const {
    const double mask = number(contact, "collide_bitmask", kAllBits);
    if (!(mask >= 0 && mask <= 4294967295.0))
      place(contact).refuse("collide_bitmask", child_text(contact, "collide_bitmask", ""),
                            "0 to 4294967295");
    return static_cast<std::uint32_t>(mask);
  }

  // Gazebo collides the triangles.
  Mesh file_mesh(const XmlNode& shape) const {
    const std::string uri = child_text(shape, "uri", "");
    Mesh mesh =
        mesh_in_metres(m_meshes.read(path_of_uri(uri, m_files[shape.file].path, m_meshes.allowed)));
    scale(vec3(shape, "scale", Vec3::Ones()), mesh);
    return mesh;
  }

  const XmlNode& m_node;
  const SdfMeshes& m_meshes;
  const std::vector<XmlFile>& m_files;
};

}  // namespace

void add_sdf_collision(const XmlNode& collision, const Pose& pose, const SdfMeshes& meshes,
                       ForeignScene& scene, ForeignBody& body) {
  const XmlNode* const geometry = collision.child("geometry");
  if (!geometry || geometry->children.empty()) return;
  const XmlNode& shape = geometry->children.front();
  const SdfCollision from(collision, meshes, scene.files);
  ForeignCollider collider;
  collider.name = sdf_name(collision);
  collider.pose = pose;
  collider.bits = from.bits();
  if (shape.tag == "plane") {
    collider.pose.rotation = collider.pose.rotation * from.z_to_normal(shape);
    if (body.fixed) return body.colliders.push_back(std::move(collider));
  }
  try {
    Mesh mesh = from.mesh_of(shape);
    if (mesh.triangles.empty()) return skip_sdf(shape, Sentence("is not read"), scene);
    collider.mesh = std::make_shared<const Mesh>(std::move(mesh));
    if (shape.tag == "sphere") collider.ball_radius = from.radius_of(shape);
    count_faces(*collider.mesh, scene);
    body.colliders.push_back(std::move(collider));
  } catch (const Error& error) {
    skip_sdf(shape, error.sentence(), scene);
  }
}

void add_sdf_mass(const XmlNode& link, const Pose& in_body, const std::vector<XmlFile>& files,
                  ForeignBody& body) {
  const XmlNode* const inertial = link.child("inertial");
  const double kg = inertial ? sdf_number(files, *inertial, "mass", 1) : 1;
  if (!(kg > 0)) return;
  Mat3 m = Mat3::Identity();
  if (const XmlNode* const inertia = inertial ? inertial->child("inertia") : nullptr) {
    const auto at = [&](const char* key, double otherwise) {
      return sdf_number(files, *inertia, key, otherwise);
    };
    m = inertia_of(
        {at("ixx", 1), at("iyy", 1), at("izz", 1), at("ixy", 0), at("ixz", 0), at("iyz", 0)});
  }
  SolidMoments moments;
  moments.spread = (0.5 * m.trace() * Mat3::Identity() - m) / kg;
  MassSum sum;
  if (body.mass) sum.add(body.mass->kilograms, moments_of(*body.mass), Pose{});
  sum.add(kg, moments, inertial ? composed(in_body, sdf_pose(files, *inertial)) : in_body);
  body.mass = sum.total();
}

void skip_sdf(const XmlNode& node, const Sentence& why, ForeignScene& scene) {
  note_once(scene.unread, say("%1: %2", XmlPlace{scene.files, node}.text(), why));
}

}  // namespace trivet
