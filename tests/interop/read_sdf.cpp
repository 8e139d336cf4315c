// Prints an .sdf as read by libsdformat: models with poses and masses, as JSON. read_sdf FILE.sdf

// Third-party headers are exempt from our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <sdf/sdf.hh>
#pragma GCC diagnostic pop

#include <cstdint>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

nlohmann::json model_json(const sdf::Model& model) {
  const ignition::math::Pose3d& pose = model.RawPose();
  const auto& p = pose.Pos();
  const auto& q = pose.Rot();
  return {{"name", model.Name()},
          {"position", {{"x", p.X()}, {"y", p.Y()}, {"z", p.Z()}}},
          {"quaternion", {{"w", q.W()}, {"x", q.X()}, {"y", q.Y()}, {"z", q.Z()}}},
          {"mass", model.LinkByIndex(0)->Inertial().MassMatrix().Mass()}};
}

int print(const std::string& path) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(path);
  for (const sdf::Error& error : errors) std::cerr << error.Message() << "\n";
  if (!errors.empty() || root.WorldCount() != 1) return 1;
  nlohmann::json out = {{"objects", nlohmann::json::array()}};
  const sdf::World& world = *root.WorldByIndex(0);
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i)
    out["objects"].push_back(model_json(*world.ModelByIndex(i)));
  std::cout << out.dump() << "\n";
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return count == 2 ? print(arguments[1]) : 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
