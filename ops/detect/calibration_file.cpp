#include "ops/detect/calibration_file.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/json.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 3;
constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostSources = 64;

Json model_json(const CostModel& model) {
  return {{"fixed_ms", model.fixed_ms},
          {"ms_per_triangle", model.ms_per_triangle},
          {"ms_per_root", model.ms_per_root},
          {"ms_per_pixel", model.ms_per_pixel}};
}

double number_of(const Json& json, const char* name) {
  const double out = json.at(name).get<double>();
  if (!(out >= 0 && std::isfinite(out)))
    throw Error(Error::Kind::BadInput, "\"%1\" is %2; accepted: numbers from 0", name,
                json.at(name).dump());
  return out;
}

CostModel model_from(const Json& json) {
  return {number_of(json, "fixed_ms"), number_of(json, "ms_per_triangle"),
          number_of(json, "ms_per_root"), number_of(json, "ms_per_pixel")};
}

Json source_json(const SourceCost& source) {
  return {{"name", source.name},
          {"device", source.device},
          {"on_cpu", source.on_cpu},
          {"failure", source.failure},
          {"start_ms", source.start_ms},
          {"drop", model_json(source.drop)},
          {"turn", model_json(source.turn)}};
}

SourceCost source_from(const Json& json) {
  return {json.at("name"),
          json.at("device"),
          json.at("on_cpu"),
          json.at("failure"),
          number_of(json, "start_ms"),
          model_from(json.at("drop")),
          model_from(json.at("turn"))};
}

std::string folder_from(const char* variable) {
  const char* value = std::getenv(variable);
  return value && value[0] == '/' ? value : "";
}

}  // namespace

std::string calibration_path() {
  // The cache may be lost at any time: it is measured again.
  std::string folder = folder_from("XDG_CACHE_HOME");
  if (folder.empty()) {
    folder = folder_from("HOME");
    if (!folder.empty()) folder += "/.cache";
  }
  return folder.empty() ? "" : folder + "/trivet/backends.json";
}

std::string to_json(const Calibration& calibration) {
  Json sources = Json::array();
  for (const SourceCost& source : calibration.sources) sources.push_back(source_json(source));
  const Json json = {{"format", kFormat},
                     {"version", calibration.key.version},
                     {"build", calibration.key.build},
                     {"cpu", calibration.key.cpu},
                     {"hardware", calibration.key.hardware},
                     {"device", calibration.key.device},
                     {"seconds", calibration.seconds},
                     {"sources", std::move(sources)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Calibration calibration_from_json(const std::string& text) {
  try {
    const Json json = json_from_text<Json>(text, "backends.json");
    // Another format is refused as a whole: the caller measures again.
    if (json.at("format") != kFormat)
      throw Error(Error::Kind::BadInput, "\"format\" is %1; accepted: 3", json.at("format").dump());
    Calibration out;
    out.key = {json.at("version"), json.at("build"), json.at("cpu"), json.at("hardware"),
               json.at("device")};
    out.seconds = number_of(json, "seconds");
    for (const Json& source : json.at("sources")) out.sources.push_back(source_from(source));
    if (out.sources.empty() || out.sources.size() > kMostSources)
      throw Error(Error::Kind::BadInput, "it has %1 sources; accepted: 1 to 64",
                  out.sources.size());
    return out;
  } catch (const Json::exception&) {
    throw Error(Error::Kind::BadInput, "a value is missing, or of another kind");
  }
}

Calibration read_calibration(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))  // opening a pipe would wait
    throw Error(Error::Kind::Environment, "%1 is no regular file", path);
  std::ifstream file(path, std::ios::binary);
  // The size is bounded: a damaged file costs no memory.
  std::string text(kMostBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.empty()) throw Error(Error::Kind::Environment, "%1 cannot be read, or is empty", path);
  return calibration_from_json(text);
}

void write_calibration(const Calibration& calibration, const std::string& path) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error(Error::Kind::Environment, "%1 cannot be made: %2", folder.string(),
                error.message().c_str());
  write_file_atomically(path, to_json(calibration));
}

}  // namespace trivet
