#include "apps/trivet/label_outputs.h"

#include <iostream>

#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_input.h"
#include "core/base/arena.h"
#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/overwrites.h"
#include "core/io/staged_files.h"
#include "core/picture/image_files.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/layout/paths.h"
#include "raster/path/picture.h"

namespace trivet::apps {
namespace {

bool is_exr(const std::string& file) { return lower_extension(file) == ".exr"; }

void check_one_view(const LabelArguments& arguments, std::size_t num_views) {
  if (num_views < 2) return;
  for (const std::string& file : label_files(arguments))
    if (file.find(kPlaceOfName) == std::string::npos)
      bad_input(
          "%1: one file for %2 views; accepted: a name with {}, which stands for that of the view",
          file, num_views);
}

// Writes the files of one view after another.
class LabelWriter {
 public:
  LabelWriter(const LabelledScene& scene, const LabelArguments& arguments,
              const PictureRequest& request, const CommonOptions& common)
      : m_scene(scene), m_arguments(arguments), m_request(request), m_common(common) {
    if (!arguments.coco.empty()) m_sets.push_back(make_coco_writer(arguments.coco, scene));
    if (!arguments.bop.empty())
      m_sets.push_back(make_bop_writer(arguments.bop, scene, arguments.depth_unit));
  }

  bool wants_visibility() const { return m_arguments.visibility || !m_sets.empty(); }
  void write(const LabelView& view);
  void finish() {
    for (const auto& set : m_sets) set->finish();
    m_files.commit();
    if (m_num_beyond > 0)
      print_note(m_common, std::to_string(m_num_beyond) + " pixels are farther than " +
                               short_number(65535 * m_arguments.depth_unit) +
                               " m, and 0 in the depth images; accepted: a larger --depth-unit");
  }

 private:
  std::string depth_bytes(const Labels& labels);
  std::string normal_bytes(const Labels& labels) const;
  void write_file(const std::string& pattern, const LabelView& view, const std::string& bytes) {
    m_files.add(with_name(pattern, view.name), bytes);
  }

  const LabelledScene& m_scene;
  const LabelArguments& m_arguments;
  const PictureRequest& m_request;
  const CommonOptions& m_common;
  std::vector<std::unique_ptr<DataSetWriter>> m_sets;
  StagedFiles m_files;
  std::int64_t m_num_beyond = 0;
};

std::string LabelWriter::depth_bytes(const Labels& labels) {
  if (is_exr(m_arguments.depth)) return encode_exr(labels.width, labels.height, 1, labels.depth);
  const DepthImage depth = depth_in_units(labels, m_arguments.depth_unit);
  m_num_beyond += depth.num_beyond;
  return encode_grey_png(labels.width, labels.height, std::span<const std::uint16_t>(depth.units));
}

std::string LabelWriter::normal_bytes(const Labels& labels) const {
  if (!is_exr(m_arguments.normals))
    return encode_rgb_png(labels.width, labels.height, packed_normals(labels));
  const std::span<const float> numbers(labels.normals.data()->data(), 3 * labels.normals.size());
  return encode_exr(labels.width, labels.height, 3, numbers);
}

void LabelWriter::write(const LabelView& view) {
  LabelOptions options;
  options.normals = !m_arguments.normals.empty();
  options.visibility = wants_visibility();
  const Labels labels = render_labels(m_scene.picture, view.camera, options);
  const auto grey = [&](const std::vector<std::uint16_t>& values) {
    return encode_grey_png(labels.width, labels.height, std::span<const std::uint16_t>(values));
  };
  const LabelArguments& a = m_arguments;
  if (!a.depth.empty()) write_file(a.depth, view, depth_bytes(labels));
  if (!a.ids.empty()) write_file(a.ids, view, grey(labels.instances));
  if (!a.classes.empty()) write_file(a.classes, view, grey(class_mask(m_scene, labels)));
  if (!a.normals.empty()) write_file(a.normals, view, normal_bytes(labels));
  if (!a.boxes.empty())
    write_file(a.boxes, view,
               readable_json(labels_json(m_scene, view, labels, options.visibility)));
  if (m_sets.empty() && a.picture.empty()) return;
  PathOptions path;
  path.bounces = m_request.bounces;
  const std::string picture =
      traced_png(m_scene.picture, view.camera, m_request.paths_per_pixel(), path);
  if (!a.picture.empty()) write_file(a.picture, view, picture);
  for (const auto& set : m_sets) set->add(view, labels, picture);
}

}  // namespace

std::vector<std::string> label_files(const LabelArguments& a) {
  std::vector<std::string> out;
  for (const std::string& file : {a.depth, a.ids, a.classes, a.normals, a.boxes, a.picture})
    if (!file.empty()) out.push_back(file);
  return out;
}

void add_label_options(CLI::App& app, LabelArguments& arguments) {
  const char* const group = "Labelled images";
  const auto file = [&](const char* name, std::string& target, const char* what) {
    app.add_option(name, target, what)->type_name("FILE")->group(group);
  };
  file("--depth", arguments.depth,
       "Write depths along the camera's axis: .exr, float32, metres; or .png, 16 bits, in "
       "--depth-unit; 0: nothing there");
  file("--ids", arguments.ids,
       "Write object numbers, from 1, as .png of 16 bits; 0: nothing there, 65535: the floor");
  file("--classes", arguments.classes, "Write class numbers, from 1, as .png of 16 bits");
  file("--normals", arguments.normals,
       "Write unit normals in the camera's frame: .exr, float32; or .png, 16 bits, where 32767 is "
       "0");
  file("--boxes", arguments.boxes, "Write the camera, the objects and their boxes, .json");
  app.add_flag("--visibility", arguments.visibility,
               "Add to --boxes the visible share of each object")
      ->group(group);
  app.add_option("--depth-unit", arguments.depth_unit, "Metres per unit of .png depths")
      ->check(number_from(1e-9, 1e9))
      ->group(group);
  app.add_option("--coco", arguments.coco, "Write a data set in COCO's format to this folder")
      ->type_name("FOLDER")
      ->group(group);
  app.add_option("--bop", arguments.bop, "Write a data set in BOP's format to this folder")
      ->type_name("FOLDER")
      ->group(group);
  add_view_options(app, arguments.views);
}

void check_label_outputs(const LabelArguments& arguments) {
  const auto check = [](const std::string& file, const std::vector<std::string>& accepted) {
    if (!file.empty()) check_extension(file, accepted);
  };
  check(arguments.depth, {".exr", ".png"});
  check(arguments.normals, {".exr", ".png"});
  check(arguments.ids, {".png"});
  check(arguments.classes, {".png"});
  check(arguments.boxes, {".json"});
  check(arguments.picture, {".png"});
  check_one_view(arguments, arguments.views.dome);
  const float nothing = 0;
  if (is_exr(arguments.depth) || is_exr(arguments.normals)) encode_exr(1, 1, 1, {&nothing, 1});
}

void write_labels(const std::string& scene_file, const LabelArguments& arguments,
                  const PictureRequest& request, const CommonOptions& common) {
  const SceneFile file = read_scene_with_layout(scene_file, common);
  std::vector<std::string> outputs = label_files(arguments);
  outputs.insert(outputs.end(), {arguments.coco, arguments.bop});
  for (const std::string& output : outputs)
    if (!output.empty())
      check_not_an_input(output, model_files(file.layout, folder_of(scene_file)));
  const LabelledScene scene = labelled_scene(file.scene, file.layout);
  const std::vector<LabelView> views = label_views(arguments.views, request, scene.picture, common);
  check_one_view(arguments, views.size());
  LabelWriter writer(scene, arguments, request, common);
  const ProgressCallback progress = terminal_progress(common);
  const auto write_all = [&] {
    for (std::size_t i = 0; i < views.size(); ++i) {
      writer.write(views[i]);
      if (progress && views.size() > 1) progress({"label", views[i].name, i + 1, views.size()});
    }
    writer.finish();
  };
  in_arena(common.num_threads, write_all);
  clear_progress_line(common);
}

}  // namespace trivet::apps
