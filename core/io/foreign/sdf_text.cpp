#include "core/io/foreign/sdf_text.h"

#include <algorithm>

#include "core/io/foreign/numbers.h"
#include "core/io/text/words.h"

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

}  // namespace trivet
