#include "core/io/foreign/joint_values.h"

#include <cmath>
#include <filesystem>

#include "core/base/bad_input.h"
#include "core/io/json.h"
#include "core/io/text/file_bytes.h"

namespace trivet {
namespace {

constexpr size_t kMostValuesBytes = size_t{16} << 20;
constexpr double kMostJointValue = 1e6;

double joint_value_in(const nlohmann::json& value, const std::string& joint,
                      const std::string& path) {
  if (!value.is_number())
    bad_file(path, "\"%1\" is of type %2; accepted: a number, metres or radians", joint,
             std::string(value.type_name()));
  const double number = value.get<double>();
  if (!(std::abs(number) <= kMostJointValue))
    bad_file(path, "\"%1\" is %2; accepted: numbers up to %3", joint, figure(number),
             figure(kMostJointValue));
  return number;
}

}  // namespace

std::string joint_values_path(const std::string& scene) { return scene + ".joints.json"; }

JointValues read_joint_values(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const std::optional<std::string> text = std::filesystem::is_regular_file(path, error)
                                              ? file_bytes(path, kMostValuesBytes)
                                              : std::nullopt;
  if (!text)
    bad_file(path, "cannot be read; accepted: a file of at most %1 bytes", kMostValuesBytes);
  const auto document = json_from_text<nlohmann::json>(*text, path);
  if (!document.is_object()) bad_file(path, "accepted: {\"joint\": number, ...}");
  JointValues out;
  for (const auto& [joint, value] : document.items())
    out[joint] = joint_value_in(value, joint, path);
  return out;
}

std::string joint_values_text(const JointValues& values) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  for (const auto& [joint, value] : values) out[joint] = value;
  return out.dump(2) + "\n";
}

}  // namespace trivet
