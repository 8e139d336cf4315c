#include "core/io/foreign/sdf_text.h"

#include <algorithm>
#include <numbers>

#include "core/io/foreign/numbers.h"
#include "core/io/text/words.h"
#include "core/motion/compose.h"

namespace trivet {

std::string trimmed_text(const XmlNode& node) {
  std::string text = node.text;
  std::replace_if(text.begin(), text.end(), is_line_end, ' ');
  return std::string(trimmed(text));
}

std::string child_text(const XmlNode& node, const char* child, const std::string& otherwise) {
  const XmlNode* const found = node.child(child);
  return found ? trimmed_text(*found) : otherwise;
}

bool is_true(const std::string& text) { return text == "1" || text == "true"; }

std::string sdf_name(const XmlNode& node) {
  const std::string* const name = node.find("name");
  return name ? *name : node.tag;
}

double sdf_number(const std::vector<XmlFile>& files, const XmlNode& node, const char* child,
                  double otherwise) {
  const XmlNode* const found = node.child(child);
  return found ? numbers_in(found->text, found->tag, {files, *found}, 1, 1)[0] : otherwise;
}

Vec3 sdf_vec3(const std::vector<XmlFile>& files, const XmlNode& node, const char* child,
              const Vec3& otherwise) {
  const XmlNode* const found = node.child(child);
  if (!found) return otherwise;
  const std::vector<double> n = numbers_in(found->text, found->tag, {files, *found}, 3, 3);
  return {n[0], n[1], n[2]};
}

Pose sdf_pose(const std::vector<XmlFile>& files, const XmlNode& node) {
  const XmlNode* const pose = node.child("pose");
  if (!pose || trimmed_text(*pose).empty()) return {};
  const std::string* const format = pose->find("rotation_format");
  const std::string* const in_degrees = pose->find("degrees");
  const bool quaternion = format && *format == "quat_xyzw";
  const size_t count = quaternion ? 7 : 6;
  const std::vector<double> n = numbers_in(pose->text, pose->tag, {files, *pose}, count, count);
  const Vec3 at(n[0], n[1], n[2]);
  if (quaternion) return {Rotation{n[6], n[3], n[4], n[5]}.normalized(), at};
  const double unit = in_degrees && is_true(*in_degrees) ? 1 : 180 / std::numbers::pi;
  const Rotation r = turn_about(Vec3::UnitZ(), n[5] * unit) *
                     turn_about(Vec3::UnitY(), n[4] * unit) *
                     turn_about(Vec3::UnitX(), n[3] * unit);
  return {r.normalized(), at};
}

}  // namespace trivet
