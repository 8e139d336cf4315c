#include "core/io/foreign/mjcf/settings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/io/text/words.h"

namespace trivet::mjcf {
namespace {

constexpr int kMostClasses = 256;  // from a class up to "main"
constexpr const char* kOrientations[] = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};

// Ways to turn replace each other: an own one removes an inherited one.
void override_with(const std::vector<std::pair<std::string, std::string>>& own,
                   std::map<std::string, std::string>& all) {
  const bool turns = std::any_of(own.begin(), own.end(), [](const auto& entry) {
    return std::find(std::begin(kOrientations), std::end(kOrientations), entry.first) !=
           std::end(kOrientations);
  });
  if (turns)
    for (const char* name : kOrientations) all.erase(name);
  for (const auto& [name, value] : own)
    if (name != "class") all[name] = value;
}

Vec3 direction(const Attributes& a, const char* name, const std::vector<double>& n, size_t at) {
  const Vec3 v(n[at], n[at + 1], n[at + 2]);
  if (!(v.norm() > 1e-14)) a.place().refuse(name, a.text(name), "a direction other than zero");
  return v;
}

Rotation from_axes(const Attributes& a, const std::vector<double>& n) {
  const Vec3 x = direction(a, "xyaxes", n, 0).normalized();
  const Vec3 given(n[3], n[4], n[5]);
  const Vec3 across = given - x * x.dot(given);
  if (!(across.norm() > 1e-14)) a.place().refuse("xyaxes", a.text("xyaxes"), "axes that differ");
  const Vec3 y = across.normalized();
  Mat3 m;
  m << x, y, x.cross(y);
  return Rotation::from_matrix(m);
}

}  // namespace

Rotation z_to(const Vec3& v) {
  const Vec3 to = v.normalized();
  const Vec3 axis = Vec3::UnitZ().cross(to);
  if (axis.norm() < 1e-10) return to.z() > 0 ? Rotation{} : Rotation{0, 1, 0, 0};
  // tan(angle / 2) = sin / (1 + cos)
  if (to.z() >= 0) return Rotation{1 + to.z(), axis.x(), axis.y(), 0}.normalized();
  const Vec3 unit = axis.normalized();  // beyond a quarter: sin / (1 + cos) = (1 - cos) / sin
  return Rotation{axis.norm(), (1 - to.z()) * unit.x(), (1 - to.z()) * unit.y(), 0}.normalized();
}

std::string Attributes::text(const std::string& name) const { return text(name, ""); }

std::string Attributes::text(const std::string& name, const std::string& otherwise) const {
  const auto it = m_values.find(name);
  return it == m_values.end() ? otherwise : it->second;
}

double Attributes::number(const std::string& name, double otherwise) const {
  return has(name) ? numbers_in(text(name), name, m_place, 1, 1)[0] : otherwise;
}

Vec3 Attributes::vec3(const std::string& name, const Vec3& otherwise) const {
  if (!has(name)) return otherwise;
  const std::vector<double> n = numbers_in(text(name), name, m_place, 3, 3);
  return {n[0], n[1], n[2]};
}

std::vector<double> Attributes::numbers(const std::string& name, size_t least, size_t most) const {
  return numbers_in(text(name), name, m_place, least, most);
}

Settings::Settings(const XmlNode& root, const std::vector<XmlFile>& files) : m_files(files) {
  for (const XmlNode& node : root.children)
    if (node.tag == "compiler")
      for (const auto& [name, value] : node.attributes) m_compiler[name] = {value, &node};
  m_classes[m_main] = {};
  for (const XmlNode& node : root.children)
    if (node.tag == "default") read_default(node, "");
}

void Settings::read_default(const XmlNode& node, const std::string& parent) {
  const std::string* const given = node.find("class");
  std::string name = given ? *given : "main";
  // The outermost class is "main", whatever its name.
  if (parent.empty() && m_classes.size() == 1 && m_classes[m_main].tags.empty() && name != m_main)
    m_classes[name] = {}, m_main = name;
  Class& mine = m_classes[name];
  if (name != m_main && mine.parent.empty()) mine.parent = parent.empty() ? m_main : parent;
  for (const XmlNode& child : node.children)
    if (child.tag != "default") override_with(child.attributes, m_classes[name].tags[child.tag]);
  for (const XmlNode& child : node.children)
    if (child.tag == "default") read_default(child, name);
}

std::map<std::string, std::string> Settings::inherited(const XmlNode& node,
                                                       const std::string& name) const {
  std::vector<const Class*> chain;
  for (std::string at = name.empty() ? m_main : name; !at.empty();) {
    const auto it = m_classes.find(at == "main" ? m_main : at);
    if (it == m_classes.end())
      XmlPlace{m_files, node}.refuse("class", at, "a class of the section <default>");
    if (static_cast<int>(chain.size()) > kMostClasses) break;
    chain.push_back(&it->second);
    at = it->second.parent;
  }
  std::map<std::string, std::string> out;
  for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
    const auto tag = (*it)->tags.find(node.tag);
    if (tag != (*it)->tags.end()) override_with({tag->second.begin(), tag->second.end()}, out);
  }
  return out;
}

Attributes Settings::attributes(const XmlNode& node, const std::string& childclass) const {
  const std::string* const own = node.find("class");
  std::map<std::string, std::string> all = inherited(node, own ? *own : childclass);
  override_with(node.attributes, all);
  return Attributes(std::move(all), XmlPlace{m_files, node});
}

double Settings::degrees(double angle) const {
  return compiler("angle", "degree") == "radian" ? angle * (180 / std::numbers::pi) : angle;
}

Rotation Settings::orientation(const Attributes& a) const {
  if (a.has("axisangle")) {
    const std::vector<double> n = a.numbers("axisangle", 4, 4);
    return turn_about(direction(a, "axisangle", n, 0).normalized(), degrees(n[3]));
  }
  if (a.has("euler")) {
    const std::vector<double> n = a.numbers("euler", 3, 3);
    const std::string sequence = compiler("eulerseq", "xyz");
    if (sequence.size() != 3 || sequence.find_first_not_of("xyzXYZ") != std::string::npos)
      a.place().refuse("eulerseq", sequence, "three letters of xyzXYZ");
    Rotation q;
    for (size_t i = 0; i < 3; ++i) {
      const bool own_axis = sequence[i] >= 'x';  // about turned axes; capitals: about fixed ones
      const Rotation one =
          turn_about(Vec3::Unit((own_axis ? sequence[i] - 'x' : sequence[i] - 'X')), degrees(n[i]));
      q = own_axis ? q * one : one * q;
    }
    return q.normalized();
  }
  if (a.has("xyaxes")) return from_axes(a, a.numbers("xyaxes", 6, 6));
  if (a.has("zaxis")) {
    const std::vector<double> n = a.numbers("zaxis", 3, 3);
    return z_to(direction(a, "zaxis", n, 0));
  }
  if (!a.has("quat")) return {};
  const std::vector<double> n = a.numbers("quat", 4, 4);
  const Rotation q{n[0], n[1], n[2], n[3]};
  return q.w == 1 && q.x == 0 && q.y == 0 && q.z == 0 ? q : q.normalized();
}

Pose Settings::pose(const Attributes& a) const {
  return {orientation(a), a.vec3("pos", Vec3::Zero())};
}

std::string Settings::compiler(const std::string& name, const std::string& otherwise) const {
  const auto it = m_compiler.find(name);
  return it == m_compiler.end() ? otherwise : it->second.first;
}

double Settings::compiler_number(const std::string& name, double otherwise) const {
  const auto it = m_compiler.find(name);
  if (it == m_compiler.end()) return otherwise;
  return numbers_in(it->second.first, name, XmlPlace{m_files, *it->second.second}, 1, 1)[0];
}

std::string Settings::mesh_path(const std::string& file) const {
  std::filesystem::path name = with_slashes(file);
  if (compiler("strippath", "false") == "true") name = name.filename();
  const std::string folder = with_slashes(compiler("meshdir", compiler("assetdir", "")));
  return (std::filesystem::path(m_files[0].path).parent_path() / folder / name)
      .lexically_normal()
      .string();
}

}  // namespace trivet::mjcf
