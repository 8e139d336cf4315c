// The tree of bodies: frames, copies, joints, inertials.
#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "core/base/bad_input.h"
#include "core/io/foreign/mjcf/model.h"

namespace trivet::mjcf {
namespace {

constexpr size_t kMostBodies = 200'000, kMostCopies = 100'000;
constexpr size_t kMostAllCopies = 200'000;  // copies within copies; leaves and bodies count each
constexpr int kMostNested = 500;

// Elements that neither collide nor weigh.
const std::set<std::string> kSilent = {"site", "camera", "light", "include"};

bool has_joint(const XmlNode& node) {
  for (const XmlNode& child : node.children)
    if (child.tag == "joint" || child.tag == "freejoint" ||
        ((child.tag == "frame" || child.tag == "replicate") && has_joint(child)))
      return true;
  return false;
}

class TreeReader {
 public:
  TreeReader(const Settings& settings, Assets& assets, const ForeignOptions& options,
             ForeignScene& scene)
      : m_settings(settings), m_assets(assets), m_options(options), m_scene(scene) {
    m_model.bodies.emplace_back().name = "world";
  }

  /// Where an element is read.
  struct Place {
    int body = 0;
    Pose frame;              // in the body
    std::string childclass;  // empty: none
    std::string suffix;      // of names, in copies
    bool is_copy = false;
    int depth = 0;
  };

  void read_world(const XmlNode& node) {
    Place place;
    if (const std::string* const c = node.find("childclass")) place.childclass = *c;
    read_leaves(node, place);
    read_bodies(node, place);
  }
  Model take() {
    // Numbers of joints follow each other in the order of the tree, as in a keyframe.
    for (Body& body : m_model.bodies)
      for (Joint& joint : body.joints) {
        joint.first_number = m_model.num_numbers;
        m_model.num_numbers += joint.num_numbers();
      }
    return std::move(m_model);
  }

 private:
  // Leaves of the body itself come before the bodies in it.
  void read_leaves(const XmlNode& node, const Place& place) {
    for (const XmlNode& child : node.children) {
      if (child.tag == "frame") {
        read_leaves(child, inside_frame(child, place));
      } else if (child.tag == "replicate") {
        for (const Place& copy : copies(child, place)) read_leaves(child, copy);
      } else if (child.tag != "body") {
        read_leaf(child, place);
      }
    }
  }

  void read_bodies(const XmlNode& node, const Place& place) {
    for (const XmlNode& child : node.children) {
      if (child.tag == "frame") {
        read_bodies(child, inside_frame(child, place));
      } else if (child.tag == "replicate") {
        for (const Place& copy : copies(child, place)) read_bodies(child, copy);
      } else if (child.tag == "body") {
        add_body(child, place);
      }
    }
  }

  Place inside_frame(const XmlNode& node, const Place& place) const {
    // A frame is no body: it shifts all that is inside it.
    Place out = place;
    const Attributes a = m_settings.attributes(node, "");
    out.frame = composed(place.frame, m_settings.pose(a));
    out.childclass = a.text("childclass", place.childclass);
    check_depth(node, ++out.depth);
    return out;
  }

  std::vector<Place> copies(const XmlNode& node, const Place& place) {
    const Attributes a = m_settings.attributes(node, "");
    // Copies within copies multiply: their number is bounded before any is made.
    const double count = a.number("count", 0);
    if (!(count >= 0 && count <= static_cast<double>(kMostCopies)))
      a.place().refuse("count", a.text("count"), say("0 to %1", kMostCopies));
    m_num_copies += static_cast<size_t>(count);
    check_depth(node, place.depth);
    const Pose step{m_settings.orientation(a), a.vec3("offset", Vec3::Zero())};
    // Numbers of copies have as many digits as the last one, so that names sort.
    const size_t digits = std::to_string(static_cast<long>(count) - 1).size();
    std::vector<Place> out;
    Pose at;
    for (int k = 0; k < static_cast<int>(count); ++k) {
      Place copy = place;
      copy.frame = composed(place.frame, at);
      copy.childclass = a.text("childclass", place.childclass);
      const std::string number = std::to_string(k);
      copy.suffix =
          place.suffix + a.text("sep") + std::string(digits - number.size(), '0') + number;
      copy.is_copy = true;
      check_depth(node, ++copy.depth);
      out.push_back(std::move(copy));
      // Without a turn the copies stand in a line, else each turns the offset of the next.
      at = {at.rotation * step.rotation, at.translation + at.rotation.matrix() * step.translation};
    }
    return out;
  }

  void check_depth(const XmlNode& node, int depth) const {
    if (depth > kMostNested || m_model.bodies.size() > kMostBodies || m_num_copies > kMostAllCopies)
      bad_input("%1: too many bodies; accepted: %2, %3 within each other",
                XmlPlace{m_settings.files(), node}.text(), kMostBodies, kMostNested);
  }

  void add_body(const XmlNode& node, const Place& place) {
    check_depth(node, place.depth + 1);
    const Attributes a = m_settings.attributes(node, "");
    Body body;
    body.name = a.text("name").empty() ? "" : a.text("name") + place.suffix;
    body.parent = place.body;
    body.node = &node;
    body.frame = place.frame;
    body.local = composed(place.frame, m_settings.pose(a));
    body.mocap = a.text("mocap") == "true";
    body.is_copy = place.is_copy;
    // A body moves if it or one above has a joint.
    body.moves = m_model.bodies[static_cast<size_t>(place.body)].moves || has_joint(node);
    const std::string rule = m_settings.compiler("inertiafromgeom", "auto");
    // Geoms weigh only where the file gives no inertia, or says that it does not count.
    body.needs_mass = body.moves && (rule == "true" || (rule == "auto" && !node.child("inertial")));
    // All inside the body counts from its own frame.
    Place inside = place;
    inside.body = static_cast<int>(m_model.bodies.size());
    inside.frame = {};
    inside.childclass = a.text("childclass", place.childclass);
    ++inside.depth;
    m_model.bodies.push_back(std::move(body));
    read_leaves(node, inside);
    read_bodies(node, inside);
  }

  void read_leaf(const XmlNode& node, const Place& place) {
    Body& body = m_model.bodies[static_cast<size_t>(place.body)];
    if (node.tag == "geom")
      read_geom(m_settings.attributes(node, place.childclass), place.frame, m_settings, m_assets,
                m_options, body, m_scene);
    else if (node.tag == "joint" || node.tag == "freejoint")
      read_joint(node, place, body);
    else if (node.tag == "inertial")
      read_inertial(node, place, body);
    else if (!kSilent.count(node.tag))
      note_once(m_scene.unread, say("%1: is not read", XmlPlace{m_settings.files(), node}.text()));
  }

  void read_joint(const XmlNode& node, const Place& place, Body& body) {
    const Attributes a = m_settings.attributes(node, place.childclass);
    const std::string type = node.tag == "freejoint" ? "free" : a.text("type", "hinge");
    Joint joint;
    if (type == "free") {
      joint.kind = Joint::Kind::Free;
      const std::string align = a.text("align", "auto");
      if (align == "true" ||
          (align == "auto" && m_settings.compiler("alignfree", "false") == "true"))
        note_once(m_scene.unread, say("%1: align is not read", a.place().text()));
    } else if (type == "ball") {
      joint.kind = Joint::Kind::Ball;
    } else if (type == "slide") {
      joint.kind = Joint::Kind::Slide;
    } else if (type != "hinge") {
      a.place().refuse("type", type, "\"free\", \"ball\", \"slide\" or \"hinge\"");
    }
    // A joint inside a frame is brought into the body.
    const Affine frame = world_from_object(place.frame, UpAxis::Z, 1);
    joint.anchor = frame.apply(a.vec3("pos", Vec3::Zero()));
    const Vec3 axis = a.vec3("axis", Vec3::UnitZ());
    if (axis.norm() > 1e-14) joint.axis = frame.apply_direction(axis.normalized());
    // Hinges have angles, in the file's unit; slides have metres.
    const auto own_unit = [&](double number) {
      return joint.kind == Joint::Kind::Hinge ? m_settings.degrees(number) : number;
    };
    joint.reference = own_unit(a.number("ref", 0));
    joint.friction = a.number("frictionloss", 0);
    joint.name = a.text("name").empty() ? "" : a.text("name") + place.suffix;
    // A range counts as a limit unless the joint says otherwise.
    if (a.has("range") && a.text("limited", "auto") != "false") {
      const std::vector<double> range = a.numbers("range", 2, 2);
      joint.lower = own_unit(range[0]), joint.upper = own_unit(range[1]);
    }
    body.joints.push_back(joint);
  }

  void read_inertial(const XmlNode& node, const Place& place, Body& body) {
    const Attributes a = m_settings.attributes(node, "");
    GivenMass mass;
    mass.kilograms = a.number("mass", 0);
    // A body without a positive mass is left to its geoms, or weighs nothing.
    if (!(mass.kilograms > 0)) return;
    const Pose pose = composed(place.frame, m_settings.pose(a));
    mass.centre = pose.translation;
    Mat3 inertia = Mat3::Zero();
    if (a.has("fullinertia")) {
      const std::vector<double> m = a.numbers("fullinertia", 6, 6);
      // The six numbers are xx, yy, zz, xy, xz, yz.
      inertia << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    } else if (a.has("diaginertia")) {
      inertia = a.vec3("diaginertia", Vec3::Zero()).asDiagonal();
    }
    // The inertia is turned into the body's axes, and made symmetric to the bit.
    const Mat3 r = pose.rotation.matrix();
    const Mat3 turned_inertia = r * inertia * r.transpose();
    mass.inertia = 0.5 * (turned_inertia + turned_inertia.transpose());
    // An inertia that no body can have is left out: mass and centre still count.
    if (refuse_mass(mass)) mass.inertia.reset();
    body.inertial = mass;
  }

  const Settings& m_settings;
  Assets& m_assets;
  const ForeignOptions& m_options;
  ForeignScene& m_scene;
  size_t m_num_copies = 0;
  Model m_model;
};

}  // namespace

Model read_bodies(const XmlNode& root, const Settings& settings, Assets& assets,
                  const ForeignOptions& options, ForeignScene& scene) {
  TreeReader reader(settings, assets, options, scene);
  for (const XmlNode& section : root.children)
    if (section.tag == "worldbody") reader.read_world(section);
  return reader.take();
}

}  // namespace trivet::mjcf
