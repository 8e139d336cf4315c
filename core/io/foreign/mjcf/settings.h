// Compiler settings and default classes of an MJCF model. Private to the reader.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/io/foreign/numbers.h"
#include "core/io/foreign/scene.h"

namespace trivet::mjcf {

/// Attributes of an element over those of its default class.
class Attributes {
 public:
  Attributes(std::map<std::string, std::string> values, XmlPlace place)
      : m_values(std::move(values)), m_place(place) {}

  bool has(const std::string& name) const { return m_values.count(name) > 0; }
  /// Empty: it has none.
  std::string text(const std::string& name) const;
  std::string text(const std::string& name, const std::string& otherwise) const;
  double number(const std::string& name, double otherwise) const;
  Vec3 vec3(const std::string& name, const Vec3& otherwise) const;
  std::vector<double> numbers(const std::string& name, size_t least, size_t most) const;
  const XmlPlace& place() const { return m_place; }

 private:
  std::map<std::string, std::string> m_values;
  XmlPlace m_place;
};

class Settings {
 public:
  /// @param root  <mujoco>, includes in place.
  Settings(const XmlNode& root, const std::vector<XmlFile>& files);

  /// @param childclass  of the nearest body or frame; empty: none.
  Attributes attributes(const XmlNode& node, const std::string& childclass) const;
  /// Position and orientation of an element in the frame that it is in.
  Pose pose(const Attributes& a) const;
  Rotation orientation(const Attributes& a) const;
  /// An angle of the file in degrees.
  double degrees(double angle) const;
  /// An attribute of <compiler>.
  std::string compiler(const std::string& name, const std::string& otherwise) const;
  double compiler_number(const std::string& name, double otherwise) const;
  /// Path of a mesh file.
  std::string mesh_path(const std::string& file) const;
  const std::vector<XmlFile>& files() const { return m_files; }

 private:
  struct Class {
    std::string parent;                                              // empty: none
    std::map<std::string, std::map<std::string, std::string>> tags;  // of elements by tag
  };

  void read_default(const XmlNode& node, const std::string& parent);
  std::map<std::string, std::string> inherited(const XmlNode& node, const std::string& name) const;

  const std::vector<XmlFile>& m_files;
  std::string m_main = "main";
  std::map<std::string, std::pair<std::string, const XmlNode*>> m_compiler;
  std::map<std::string, Class> m_classes;
};

/// The shortest turn that takes z to a direction of any length but zero.
Rotation z_to(const Vec3& direction);

}  // namespace trivet::mjcf
