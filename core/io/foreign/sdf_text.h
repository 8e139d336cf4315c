// Texts and numbers of SDF, which are in elements.
#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/io/foreign/xml_text.h"
#include "core/motion/pose.h"

namespace trivet {

std::string trimmed_text(const XmlNode& node);
std::string child_text(const XmlNode& node, const char* child, const std::string& otherwise);
bool is_true(const std::string& text);
/// The name; without one the tag.
std::string sdf_name(const XmlNode& node);

/// Numbers of a child. @throws Error (BadInput) naming the place.
double sdf_number(const std::vector<XmlFile>& files, const XmlNode& node, const char* child,
                  double otherwise);
Vec3 sdf_vec3(const std::vector<XmlFile>& files, const XmlNode& node, const char* child,
              const Vec3& otherwise);

/// Its <pose>, whatever that is relative to. @throws Error (BadInput) naming the place.
Pose sdf_pose(const std::vector<XmlFile>& files, const XmlNode& node);

}  // namespace trivet
