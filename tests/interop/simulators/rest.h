// Shared by the programs of engines in C++: command line, starting poses and lines of JSON.
// rest.mjs is the same for engines in JavaScript, and says how to call them.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rest {

using Json = nlohmann::ordered_json;

struct Start {
  std::vector<double> position, rotation;  // metres; w, x, y, z
};
using Starts = std::map<std::string, Start>;  // by the names of bodies

inline Starts starts_of(const std::string& line) {
  Starts out;
  const Json poses = Json::parse(line);
  for (const auto& [name, pose] : poses.items())
    out[name] = {pose.at("position"), pose.at("rotation")};
  return out;
}

/// Worlds of a scene: one for each line of the file, or the scene's own.
inline std::vector<Starts> read_starts(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<Starts> out;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) out.push_back(starts_of(line));
  return out;
}

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A line of a simulated world, which has: simulator(), timestep(), penetration(), step(),
/// warnings(), num_hulls() and objects(), JSON.
template <class World>
Json simulate(const std::string& scene, double seconds, const Starts& starts) {
  World world(scene, starts);
  const double penetration = world.penetration();
  const long steps = std::lround(seconds / world.timestep());
  const double before = cpu_seconds();
  for (long i = 0; i < steps; ++i) world.step();
  const double used = std::max(cpu_seconds() - before, 1e-6);
  return {{"simulator", world.simulator()},
          {"scene", std::filesystem::path(scene).stem().string()},
          {"seconds", seconds},
          {"penetration", penetration},
          {"warnings", world.warnings()},
          {"hulls", world.num_hulls()},
          {"steps_per_cpu_second", std::lround(static_cast<double>(steps) / used)},
          {"cpu_seconds", used},
          {"objects", world.objects()}};
}

/// SECONDS [--starts STARTS.jsonl] SCENE.xml...
template <class World>
int run(int count, char** arguments) {
  try {
    std::vector<std::string> scenes(arguments + 1, arguments + count);
    const double seconds = std::stod(scenes.at(0));
    std::vector<Starts> worlds(1);
    size_t first = 1;
    if (scenes.at(1) == "--starts") {
      worlds = read_starts(scenes.at(2));
      first = 3;
    }
    for (size_t i = first; i < scenes.size(); ++i)
      for (const Starts& starts : worlds)
        std::cout << simulate<World>(scenes[i], seconds, starts).dump() << std::endl;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}

}  // namespace rest
