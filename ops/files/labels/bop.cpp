#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "core/base/bad_input.h"
#include "core/io/json.h"
#include "core/io/staged_files.h"
#include "ops/files/labels/bop_models.h"
#include "ops/files/labels/bop_scene.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// "000017" of a scene's folder.
std::optional<int> scene_number(const std::string& name) {
  const bool digits = name.size() == 6 && std::all_of(name.begin(), name.end(),
                                                      [](char c) { return '0' <= c && c <= '9'; });
  return digits ? std::optional(std::stoi(name)) : std::nullopt;
}

int next_scene(const std::string& folder) {
  int next = 0;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (const auto number = scene_number(entry.path().filename().string()))
      next = std::max(next, *number + 1);
  if (next > 999'999) bad_input("%1: has scene 999999 already; accepted: another folder", folder);
  return next;
}

/// Models that a set has, with room for more.
class SetModels {
 public:
  explicit SetModels(const std::string& folder) : m_folder(folder + "/models/") {
    const std::string file = m_folder + "models_info.json";
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return;
    const auto read = json_if_valid<OrderedJson>(read_text_file(file, kMaxSetBytes));
    if (!read || !read->is_object() || read->size() > 100'000)
      bad_file(file, "is no list of models; accepted: a set that Trivet wrote, or a new folder");
    m_info = *read;
  }

  /// The id of the model in the set; one that is new gets the next.
  int add(const LabelledModel& model, StagedFiles& files) {
    int next = 1;
    for (const auto& [key, value] : m_info.items()) next = std::max(next, number(key) + 1);
    const BopModel made = bop_model(model, next);
    for (const auto& [key, value] : m_info.items())
      if (value.is_object() && value.value("diameter", OrderedJson()) == made.info["diameter"])
        if (is_same(made.texture.empty() ? made : bop_model(model, number(key)), number(key)))
          return number(key);
    const std::string stem = m_folder + bop_model_name(next);
    files.add(stem + ".ply", made.ply);
    if (!made.texture.empty()) files.add(stem + ".png", made.texture);
    m_info[std::to_string(next)] = made.info;
    m_new[next] = made;
    return next;
  }
  void write(StagedFiles& files) const {
    files.add(m_folder + "models_info.json", readable_json(m_info));
  }

 private:
  int number(const std::string& key) const {
    if (key.empty() || key.size() > 6 || key.find_first_not_of("0123456789") != std::string::npos)
      bad_file(m_folder + "models_info.json", "has the key \"%1\"; accepted: numbers", key);
    return std::stoi(key);
  }
  static std::string bytes_if_there(const std::string& file) {
    std::error_code ignored;
    return fs::exists(file, ignored) ? read_text_file(file, kMaxSetBytes) : "";
  }
  bool is_same(const BopModel& model, int id) const {
    if (const auto made = m_new.find(id); made != m_new.end())
      return made->second.ply == model.ply && made->second.texture == model.texture;
    const std::string stem = m_folder + bop_model_name(id);
    return bytes_if_there(stem + ".ply") == model.ply &&
           bytes_if_there(stem + ".png") == model.texture;
  }

  std::string m_folder;
  OrderedJson m_info = OrderedJson::object();
  std::map<int, BopModel> m_new;
};

class BopWriter : public DataSetWriter {
 public:
  BopWriter(const std::string& folder, const LabelledScene& scene, double depth_unit)
      : m_folder(folder), m_unit(depth_unit), m_models(folder) {
    const std::string views = folder + "/" + number_text(next_scene(folder));
    for (const char* part : {"rgb", "depth", "mask", "mask_visib"})
      m_files.add_folder(views + "/" + part);
    m_files.add_folder(m_folder + "/models");
    std::vector<int> ids;
    for (const LabelledModel& model : scene.models) ids.push_back(m_models.add(model, m_files));
    const auto sink = [this, views](const std::string& name, const std::string& bytes) {
      m_files.add(views + "/" + name, bytes);
    };
    m_scene.emplace(scene, depth_unit, sink, std::move(ids));
  }

  void add(const LabelView& view, const Labels& labels, const std::string& picture) override {
    if (m_first_camera.empty()) m_first_camera = bop_camera_json(view.camera, m_unit);
    m_scene->add(view, labels, picture);
  }
  void finish() override {
    m_models.write(m_files);
    std::error_code ignored;
    if (!fs::exists(m_folder + "/camera.json", ignored))
      m_files.add(m_folder + "/camera.json", readable_json(m_first_camera));
    m_scene->finish();
    m_files.commit();
  }

 private:
  std::string m_folder;
  double m_unit;
  StagedFiles m_files;
  SetModels m_models;
  std::optional<BopScene> m_scene;
  OrderedJson m_first_camera;
};

}  // namespace

std::unique_ptr<DataSetWriter> make_bop_writer(const std::string& folder,
                                               const LabelledScene& scene, double depth_unit) {
  return std::make_unique<BopWriter>(folder, scene, depth_unit);
}

}  // namespace trivet
