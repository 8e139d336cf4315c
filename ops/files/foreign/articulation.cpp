#include "ops/files/foreign/articulation.h"

#include <algorithm>
#include <filesystem>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/base/quoted.h"
#include "core/motion/compose.h"
#include "ops/files/foreign/open_scene.h"
#include "ops/files/foreign/pair_table.h"

namespace trivet {
namespace {

constexpr char kBodyMark = '#';

OpenedScene opened_articulation(const std::string& path, const ImportLimits& limits) {
  const std::string extension = lower_extension(path);
  if (extension != ".xml" && extension != ".mjcf" && extension != ".urdf" && extension != ".sdf")
    bad_file(path, "is no articulation; accepted: MJCF, URDF and SDF (.xml .mjcf .urdf .sdf)");
  OpenOptions options;
  options.limits = limits;
  return open_scene(path, options);
}

class Articulation {
 public:
  Articulation(const PlacedArticulation& placed, const OpenedScene& opened, Layout& layout)
      : m_placed(placed), m_scene(opened.judged.scene), m_opened(opened), m_layout(layout) {}

  void add() {
    for (const ObjectId id : parents_first()) add_object(id);
    if (m_opened.judged.moving_links) add_pairs(*m_opened.judged.moving_links);
  }

 private:
  std::string name_of(ObjectId id) const { return m_placed.name + "/" + m_scene.at(id).name; }

  // In the frame of the file, where its floor is not raised to zero.
  Pose pose_of(ObjectId id) const {
    const Pose world = composed(m_placed.pose, pose_in_file(m_opened.judged, m_scene.at(id).pose));
    return {world.rotation.normalized(), world.translation};
  }

  // In layouts, objects hang in those before them.
  std::vector<ObjectId> parents_first() const {
    std::vector<ObjectId> ids = m_scene.ids();
    const auto depth = [&](ObjectId id) {
      return std::count_if(m_opened.joints.begin(), m_opened.joints.end(), [&](const auto& joint) {
        return std::count(joint.links.begin(), joint.links.end(), id) > 0;
      });
    };
    // Among those in the same joints, the one that hangs in them comes first.
    const auto follows = [&](ObjectId id) {
      return std::none_of(m_opened.joints.begin(), m_opened.joints.end(),
                          [&](const auto& joint) { return joint.links[0] == id; }) &&
             std::none_of(m_opened.standing.begin(), m_opened.standing.end(),
                          [&](const auto& piece) { return piece[0] == id; });
    };
    std::stable_sort(ids.begin(), ids.end(), [&](ObjectId a, ObjectId b) {
      return std::pair(depth(a), follows(a)) < std::pair(depth(b), follows(b));
    });
    return ids;
  }

  void add_object(ObjectId id) {
    const Object& object = m_scene.at(id);
    LayoutObject out;
    out.name = name_of(id);
    out.model = m_placed.file + kBodyMark + object.name;
    out.pose = pose_of(id);
    out.material = object.material;
    out.mass = object.given_mass;
    out.joint = joint_of(id);
    out.fixed = out.joint || (object.fixed && m_placed.fixed);
    m_layout.objects.push_back(std::move(out));
  }

  std::optional<NamedJoint> joint_of(ObjectId id) const {
    const SceneJoint* smallest = nullptr;
    for (const SceneJoint& joint : m_opened.joints) {
      if (joint.links[0] == id) return own_joint(joint);
      const bool goes_along = std::count(joint.links.begin(), joint.links.end(), id) > 0;
      if (goes_along && (!smallest || joint.links.size() < smallest->links.size()))
        smallest = &joint;
    }
    if (smallest) return held_in(smallest->links[0]);
    // A piece that stands free is one body, whatever joins it.
    for (const std::vector<ObjectId>& piece : m_opened.standing)
      if (piece[0] != id && std::count(piece.begin(), piece.end(), id) > 0)
        return held_in(piece[0]);
    return std::nullopt;
  }

  // A link that hangs in nothing has none: it stays where it is.
  std::optional<NamedJoint> own_joint(const SceneJoint& joint) const {
    if (joint.frames.empty()) return std::nullopt;
    const Pose link = m_scene.at(joint.links[0]).pose;
    const Mat3 back = link.rotation.matrix().transpose();
    NamedJoint out;
    out.in = name_of(joint.frames[0]);
    out.joint.kind = joint.turns ? LinkJoint::Kind::Hinge : LinkJoint::Kind::Slide;
    out.joint.axis = (back * joint.axis).normalized();
    if (joint.turns) out.joint.anchor = back * (joint.anchor - link.translation);
    out.joint.value = joint.value;
    const bool is_held = !joint.held.empty();
    // Files may state values beyond their limits.
    out.joint.lower = is_held ? joint.value : std::min(joint.lower, joint.value);
    out.joint.upper = is_held ? joint.value : std::max(joint.upper, joint.value);
    return out;
  }

  // As a joint without a way to go.
  NamedJoint held_in(ObjectId parent) const {
    NamedJoint out;
    out.in = name_of(parent);
    out.joint.lower = out.joint.upper = 0;
    return out;
  }

  void add_pairs(const PairTable& table) {
    const std::vector<std::optional<ObjectId>>& ids = m_opened.judged.ids;
    for (size_t i = 0; i < ids.size(); ++i)
      for (size_t j = i + 1; j < ids.size(); ++j) {
        if (!ids[i] || !ids[j]) continue;
        const PairRule* const rule = table.rules->find(table.kinds[i], table.kinds[j]);
        if (rule && rule->may_pass) add_pair(*ids[i], *ids[j]);
      }
  }

  void add_pair(ObjectId a, ObjectId b) {
    NamedPairRule out{name_of(a), name_of(b), {}};
    out.rule.may_pass = true;
    m_layout.pairs.push_back(std::move(out));
  }

  const PlacedArticulation& m_placed;
  const Scene& m_scene;
  const OpenedScene& m_opened;
  Layout& m_layout;
};

}  // namespace

void add_articulation(const PlacedArticulation& placed, const std::string& folder, Layout& layout) {
  const std::string path = (std::filesystem::path(folder) / placed.file).string();
  const OpenedScene opened = opened_articulation(path, {});
  Articulation(placed, opened, layout).add();
}

bool is_link_model(const std::string& path) {
  const size_t mark = path.find(kBodyMark);
  if (mark == std::string::npos) return false;
  const std::string extension = lower_extension(path.substr(0, mark));
  return extension == ".xml" || extension == ".mjcf" || extension == ".urdf" || extension == ".sdf";
}

Model link_model(const std::string& path, const ImportLimits& limits) {
  const size_t mark = path.find(kBodyMark);
  const std::string file = path.substr(0, mark), body = path.substr(mark + 1);
  const OpenedScene opened = opened_articulation(file, limits);
  const Scene& scene = opened.judged.scene;
  const auto id = scene.find(body);
  if (!id) bad_file(file, "has no body %1 that collides", trivet::quoted(body));
  return *scene.at(*id).model;
}

}  // namespace trivet
