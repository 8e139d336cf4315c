#include "core/io/foreign/write_back.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/bad_input.h"
#include "core/io/foreign/tag_text.h"
#include "core/motion/motion.h"

namespace trivet {
namespace {

bool same_turn(const Rotation& a, const Rotation& b) {
  // Quaternions of both signs are one turn.
  const auto differs = [&](double sign) {
    return std::max({std::abs(a.w - sign * b.w), std::abs(a.x - sign * b.x),
                     std::abs(a.y - sign * b.y), std::abs(a.z - sign * b.z)});
  };
  return std::min(differs(1), differs(-1)) <= 1e-15;
}

// The first three numbers of a text, 0 where it is empty, moved by what the body moved: a way that
// does not go along an axis changes no bit of its number.
Vec3 moved_position(const std::string& old, const ForeignBody& body, const Pose& pose) {
  // The way is turned into the frame that the numbers are in.
  const Vec3 way = pose.translation - body.pose.translation;
  const Vec3 shift = body.place.world_from_place.rotation.matrix().transpose() * way;
  Vec3 out = Vec3::Zero();
  const std::vector<TextWord> words = text_words(old);
  for (size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Index>(i);
    // Numbers that the file lacks begin at zero.
    if (words.size() >= 3) out[k] = number_at(old, words[i]);
    if (std::abs(shift[k]) > 1e-15 * way.norm()) out[k] += shift[k];
  }
  return out;
}

std::vector<double> numbers_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
std::vector<double> numbers_of(const Rotation& r) { return {r.w, r.x, r.y, r.z}; }

// A free body's seven numbers in a keyframe.
void set_numbers(const ForeignBody& body, const Pose& pose, JointNumbers& numbers) {
  // A turn that has not changed keeps the file's digits.
  const bool turned = !same_turn(pose.rotation, body.pose.rotation);
  const std::vector<double> p = numbers_of(pose.translation), r = numbers_of(pose.rotation);
  for (size_t i = 0; i < 3; ++i) numbers[body.place.number + i] = p[i];
  if (turned)
    for (size_t i = 0; i < 4; ++i) numbers[body.place.number + 3 + i] = r[i];
}

// Angle of (x, y) from the x axis, radians; the same bits on every machine.
double angle_of(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0)) return 0;
  constexpr double kRadians = std::numbers::pi / 180;
  // tan(angle / 2) by the form without cancellation; beyond a quarter turn from the other side.
  if (x >= 0) return kRadians * turned_deg(y / (length + x));
  return (y < 0 ? -1 : 1) * (std::numbers::pi - kRadians * turned_deg(std::abs(y) / (length - x)));
}

// About fixed axes x, y, z in this order.
std::vector<double> roll_pitch_yaw(const Rotation& rotation) {
  const Mat3 m = rotation.matrix();
  const double level = std::sqrt(m(0, 0) * m(0, 0) + m(1, 0) * m(1, 0));
  const double pitch = angle_of(level, -m(2, 0));
  // Right up or down, roll and yaw are one turn: all of it is roll.
  if (level < 1e-9) return {angle_of(m(1, 1), -m(1, 2)), pitch, 0};
  return {angle_of(m(2, 2), m(2, 1)), pitch, angle_of(m(0, 0), m(1, 0))};
}

/// A replacement of bytes of one file.
struct Edit {
  size_t begin, end;
  std::string text;
};

class Editor {
 public:
  // @param values  of joints; without a keyframe they need a new one, which then has all poses.
  Editor(const ForeignScene& scene, const JointNumbers& values)
      : m_scene(scene),
        m_edits(scene.files.size()),
        m_has_new_key(!values.empty() && scene.key.empty()) {
    if (values.empty()) return;
    if (m_has_new_key && !scene.new_key)
      bad_file(scene.files[0].path, "has no place for the value of a joint: %1",
               scene.why_no_key.empty() ? say("%1 has none", scene.format) : scene.why_no_key);
    if (m_has_new_key)
      m_new_key = values;
    else
      m_keys[key_place()] = values;
  }

  void edit(const ForeignBody& body, const Pose& pose) {
    // A new keyframe holds all poses: tags stay as they are.
    if (m_has_new_key && body.place.kind == PosePlace::Kind::Tag)
      return set_numbers(body, pose, m_new_key);
    switch (body.place.kind) {
      case PosePlace::Kind::Prim:  // of layers, which are not edited
      case PosePlace::Kind::Nowhere:
        bad_input("\"%1\" has no place for a pose in %2: %3", body.name, m_scene.files[0].path,
                  body.place.why_not);
      case PosePlace::Kind::Key:
        return edit_key(body, pose);
      case PosePlace::Kind::Tag:
        return edit_tag(body, pose);
      case PosePlace::Kind::Element:
        return edit_element(body, pose);
    }
  }

  std::vector<std::string> take() {
    add_keys();
    add_new_key();
    std::vector<std::string> out;
    for (size_t f = 0; f < m_edits.size(); ++f) {
      std::string bytes = m_scene.files[f].bytes;
      // Edits go from the last to the first, so that places before them stay.
      std::sort(m_edits[f].begin(), m_edits[f].end(),
                [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
      for (const Edit& e : m_edits[f]) bytes.replace(e.begin, e.end - e.begin, e.text);
      out.push_back(std::move(bytes));
    }
    return out;
  }

 private:
  // One keyframe holds the numbers of all bodies.
  void edit_key(const ForeignBody& body, const Pose& pose) {
    set_numbers(body, pose, m_keys[{body.place.file, body.place.begin}]);
  }

  // The start tag of the keyframe that the poses are of.
  std::pair<size_t, size_t> key_place() const { return {m_scene.key_file, m_scene.key_begin}; }

  void add_new_key() {
    if (!m_has_new_key) return;
    // The new key begins as the scene stands.
    std::vector<double> numbers = m_scene.numbers;
    for (const auto& [i, value] : m_new_key) numbers.at(i) = value;
    m_edits[0].push_back({*m_scene.new_key, *m_scene.new_key,
                          "  <keyframe>\n    <key name=\"moved\" qpos=\"" +
                              with_numbers("", numbers) + "\"/>\n  </keyframe>\n"});
  }

  void add_keys() {
    for (const auto& [place, changes] : m_keys) {
      const std::string tag = tag_at(place.first, place.second);
      const std::string old = attribute_of(tag, "qpos");
      std::string value = old;
      const std::vector<TextWord> words = text_words(old);
      // Words are replaced from the last to the first.
      for (auto it = changes.rbegin(); it != changes.rend(); ++it) {
        const TextWord& w = words.at(it->first);
        value.replace(w.begin, w.end - w.begin,
                      with_numbers(old.substr(w.begin, w.end - w.begin), {it->second}));
      }
      replace_tag(place.first, place.second, tag, with_attributes(tag, {{"qpos", value}}));
    }
  }

  void edit_tag(const ForeignBody& body, const Pose& pose) {
    const PosePlace& place = body.place;
    // The tag's numbers are in the frame of its parent.
    const Pose local = composed(inverse(place.world_from_place), pose);
    const std::string tag = tag_at(place.file, place.begin);
    const bool urdf = m_scene.format == "URDF";
    std::vector<std::pair<std::string, std::string>> changes;
    const std::string key = urdf ? "xyz" : "pos", old = attribute_of(tag, key);
    const Vec3 position = moved_position(old, body, pose);
    const std::string text = with_numbers(old, numbers_of(position));
    // A tag without a position gets one only if it moved.
    if (text != old && !(old.empty() && position.isZero(0))) changes = {{key, text}};
    if (!same_turn(pose.rotation, body.pose.rotation)) {
      const Rotation turn = local.rotation.normalized();
      if (urdf) {
        changes.emplace_back("rpy", with_numbers(attribute_of(tag, "rpy"), roll_pitch_yaw(turn)));
      } else {
        changes.emplace_back("quat", with_numbers(attribute_of(tag, "quat"), numbers_of(turn)));
        // One way to tell the turn is left: the others would contradict it.
        for (const char* other : {"euler", "axisangle", "xyaxes", "zaxis"})
          changes.emplace_back(other, "");
      }
    }
    replace_tag(place.file, place.begin, tag, with_attributes(tag, changes));
  }

  // The text of <pose>, which is put in where there is none.
  void edit_element(const ForeignBody& body, const Pose& pose) {
    const PosePlace& place = body.place;
    const Pose local = composed(inverse(place.world_from_place), pose);
    // Without a <pose> the whole element is written, if the body moved.
    if (!place.element) {
      if (pose.translation == body.pose.translation && same_turn(pose.rotation, body.pose.rotation))
        return;
      std::vector<double> numbers = numbers_of(local.translation);
      for (const double angle : roll_pitch_yaw(local.rotation)) numbers.push_back(angle);
      m_edits[place.file].push_back(
          {place.content, place.content, "<pose>" + with_numbers("", numbers) + "</pose>"});
      return;
    }
    const XmlNode& node = *place.element;
    const std::string& bytes = m_scene.files[place.file].bytes;
    const std::string old = bytes.substr(node.content, node.end - node.content);
    // Angles stay as they are written unless the body turned.
    std::vector<double> numbers = numbers_of(moved_position(old, body, pose));
    const std::vector<double> turn = same_turn(pose.rotation, body.pose.rotation)
                                         ? angles_that_stand(old)
                                         : angles_as_in(node, local.rotation);
    numbers.insert(numbers.end(), turn.begin(), turn.end());
    const std::string text = with_numbers(old, numbers);
    if (text != old) m_edits[place.file].push_back({node.content, node.end, text});
  }

  // Numbers behind the position, as they are.
  static std::vector<double> angles_that_stand(const std::string& text) {
    std::vector<double> out;
    const std::vector<TextWord> words = text_words(text);
    for (size_t i = 3; i < words.size(); ++i) out.push_back(number_at(text, words[i]));
    return out;
  }

  static std::vector<double> angles_as_in(const XmlNode& node, const Rotation& turn) {
    const std::string* const format = node.find("rotation_format");
    if (format && *format == "quat_xyzw") return {turn.x, turn.y, turn.z, turn.w};
    std::vector<double> out = roll_pitch_yaw(turn);
    const std::string* const degrees = node.find("degrees");
    if (degrees && (*degrees == "true" || *degrees == "1"))
      for (double& angle : out) angle *= 180 / std::numbers::pi;
    return out;
  }

  std::string tag_at(size_t file, size_t begin) const {
    const std::string& bytes = m_scene.files[file].bytes;
    return bytes.substr(begin, end_of_tag(bytes, begin) - begin);
  }
  void replace_tag(size_t file, size_t begin, const std::string& old, std::string text) {
    if (text != old) m_edits[file].push_back({begin, begin + old.size(), std::move(text)});
  }

  const ForeignScene& m_scene;
  std::vector<std::vector<Edit>> m_edits;  // by file
  std::map<std::pair<size_t, size_t>, JointNumbers> m_keys;
  bool m_has_new_key;
  JointNumbers m_new_key;
};

}  // namespace

std::vector<std::string> files_with_poses(const ForeignScene& scene,
                                          const std::map<size_t, Pose>& poses,
                                          const JointNumbers& joints) {
  Editor editor(scene, joints);
  for (const auto& [body, pose] : poses) editor.edit(scene.bodies.at(body), pose);
  return editor.take();
}

std::vector<double> numbers_with_poses(const ForeignScene& scene,
                                       const std::map<size_t, Pose>& poses,
                                       const JointNumbers& joints) {
  JointNumbers changes = joints;
  for (const auto& [body, pose] : poses) set_numbers(scene.bodies.at(body), pose, changes);
  std::vector<double> out = scene.numbers;
  for (const auto& [i, value] : changes) out.at(i) = value;
  return out;
}

}  // namespace trivet
