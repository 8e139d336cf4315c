// Text of USD files. Private.
#pragma once

#include <string>
#include <vector>

#include "core/io/simulators/simulation_files.h"

namespace trivet {

inline std::string usda_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

inline std::string usda_tuple(std::initializer_list<double> values) {
  std::string out = "(";
  out += numbers_text(values, ", ");
  return out += ')';
}
inline std::string usda_tuple(const Vec3& v) { return usda_tuple({v.x(), v.y(), v.z()}); }
inline std::string usda_tuple(const Rotation& r) { return usda_tuple({r.w, r.x, r.y, r.z}); }

/// Lines indented by two spaces per open brace.
class UsdaText {
 public:
  explicit UsdaText(const std::string& default_prim) {
    m_text = "#usda 1.0\n(\n  defaultPrim = " + usda_quoted(default_prim) +
             "\n  doc = \"Made by Trivet\"\n  kilogramsPerUnit = 1\n  metersPerUnit = 1\n"
             "  upAxis = \"Z\"\n)\n";
  }

  /// def TYPE "NAME" (metadata) {
  void open(const std::string& type, const std::string& name,
            const std::vector<std::string>& metadata = {}) {
    line("def " + type + (type.empty() ? "" : " ") + usda_quoted(name) +
         (metadata.empty() ? "" : " ("));
    for (const std::string& entry : metadata) line("  " + entry);
    if (!metadata.empty()) line(")");
    line("{");
    ++m_depth;
  }
  void close() {
    --m_depth;
    line("}");
  }
  void line(const std::string& text) {
    m_text.append(2 * m_depth, ' ');
    m_text += text;
    m_text += '\n';
  }
  std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
  size_t m_depth = 0;
};

inline std::string usda_apis(std::initializer_list<const char*> names) {
  std::string list;
  for (const char* name : names) list += (list.empty() ? "" : ", ") + usda_quoted(name);
  return "prepend apiSchemas = [" + list + "]";
}

/// The way in which MuJoCo computes contacts of a prim with MjcCollisionAPI.
void add_mujoco_contacts(UsdaText& text);

}  // namespace trivet
