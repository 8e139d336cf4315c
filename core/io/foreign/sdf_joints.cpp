#include "core/io/foreign/sdf_joints.h"

#include <cmath>

#include "core/io/foreign/numbers.h"
#include "core/io/foreign/sdf_text.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

constexpr double kNoSdfLimit = 1e15;  // 1e16 stands for none

class SdfJointReader {
 public:
  SdfJointReader(const SdfLinks& links, ForeignScene& scene) : m_links(links), m_scene(scene) {}

  void add(const XmlNode& node, std::vector<TreeJoint>& joints) {
    const std::string* const type = node.find("type");
    if (type && *type == "fixed") return add_fixed(node, joints);
    ++m_scene.num_joints;
    TreeJoint joint;
    joint.name = m_links.model + "::" + sdf_name(node);
    // A joint to a link of another model, or to none, is told and left out.
    const std::optional<size_t> child = body(node, "child");
    joint.parent = body(node, "parent");
    const bool is_outside = !joint.parent && child_text(node, "parent", "") != "world";
    if (!child || is_outside)
      note_once(m_scene.notes,
                say("the joint \"%1\" is not read: it is not between links of one model; "
                    "they stay where they are",
                    joint.name));
    if (!child) return;
    joint.child = *child;
    if (is_outside) return joints.push_back(std::move(joint));  // it holds the link, no more
    if (type) joint.kind = kind_of(*type);
    if (!joint.kind)
      note_once(m_scene.notes, say("the joint \"%1\" is of type %2: its link stays where it is",
                                   joint.name, type ? *type : std::string("(none)")));
    // The joint's own frame gives anchor and axis where nothing else is said.
    const Pose at = m_links.pose_of_joint(node);
    joint.anchor = at.translation;
    joint.axis = at.rotation.normalized().matrix().col(2);
    if (const XmlNode* const axis = node.child("axis")) read_axis(*axis, at, joint);
    joints.push_back(std::move(joint));
  }

 private:
  // Links fixed to each other are one body already.
  void add_fixed(const XmlNode& node, std::vector<TreeJoint>& joints) const {
    const std::optional<size_t> child = body(node, "child");
    if (!child || child_text(node, "parent", "") != "world") return;
    TreeJoint joint;
    joint.name = m_links.model + "::" + sdf_name(node);
    joint.child = *child;
    joints.push_back(std::move(joint));
  }

  XmlPlace place(const XmlNode& node) const { return {m_scene.files, node}; }

  std::optional<size_t> body(const XmlNode& joint, const char* tag) const {
    const auto it = m_links.group.find(child_text(joint, tag, ""));
    return it == m_links.group.end() ? std::nullopt : std::optional(m_links.body_of.at(it->second));
  }

  static std::optional<ForeignJoint::Kind> kind_of(const std::string& type) {
    if (type == "prismatic") return ForeignJoint::Kind::Slide;
    if (type == "revolute" || type == "continuous") return ForeignJoint::Kind::Hinge;
    return std::nullopt;
  }

  void read_axis(const XmlNode& node, const Pose& at, TreeJoint& joint) const {
    const XmlNode* const xyz = node.child("xyz");
    const std::string* const frame = xyz ? xyz->find("expressed_in") : nullptr;
    // The frame that the axis is given in depends on the version of the format.
    Pose base = at;
    if (m_links.model_axes || is_true(child_text(node, "use_parent_model_frame", "0")))
      base = m_links.world;
    if (frame && !frame->empty()) base = m_links.pose_of(*xyz, *frame);
    const Vec3 axis = sdf_vec3(m_scene.files, node, "xyz", Vec3::UnitZ());
    if (!(axis.norm() > 1e-14)) place(node).refuse("xyz", "", "a direction");
    joint.axis = (base.rotation.normalized().matrix() * axis).normalized();
    if (const XmlNode* const limit = node.child("limit")) {
      joint.lower = limit_in(*limit, "lower", -kInfinity);
      joint.upper = limit_in(*limit, "upper", kInfinity);
    }
    if (const XmlNode* const dynamics = node.child("dynamics"))
      joint.friction = sdf_number(m_scene.files, *dynamics, "friction", 0);
    if (const XmlNode* const mimic = node.child("mimic")) joint.mimic = mimic_of(*mimic);
  }

  double limit_in(const XmlNode& limit, const char* child, double none) const {
    const std::string text = child_text(limit, child, "inf");
    if (text == "inf" || text == "+inf" || text == "-inf") return none;
    const auto number = number_from(text);
    if (!number) place(limit).refuse(child, text, "a number");
    return std::abs(*number) < kNoSdfLimit ? *number : none;
  }

  MimicRule mimic_of(const XmlNode& node) const {
    const auto number = [&](const char* child, double otherwise) {
      return sdf_number(m_scene.files, node, child, otherwise);
    };
    MimicRule out;
    const std::string* const other = node.find("joint");
    out.joint = m_links.model + "::" + (other ? *other : "");
    out.multiplier = number("multiplier", 1);
    // The reference is taken into the offset: follower = multiplier value + offset.
    out.offset = number("offset", 0) - out.multiplier * number("reference", 0);
    return out;
  }

  const SdfLinks& m_links;
  ForeignScene& m_scene;
};

}  // namespace

void add_sdf_joints(const XmlNode& model, const SdfLinks& links, ForeignScene& scene,
                    std::vector<TreeJoint>& joints) {
  SdfJointReader reader(links, scene);
  for (const XmlNode& node : model.children)
    if (node.tag == "joint") reader.add(node, joints);
}

}  // namespace trivet
