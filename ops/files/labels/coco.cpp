#include <filesystem>

#include "core/io/staged_files.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

// Mask of one instance within its box, else empty.
std::vector<bool> instance_mask(const Labels& labels, int instance) {
  std::vector<bool> mask(labels.instances.size());
  const LabelBox& box = labels.objects[instance - 1].visible_box;
  for (int y = int(box.y0); y <= int(box.y1); ++y)
    for (int x = int(box.x0); x <= int(box.x1); ++x) {
      const std::size_t i = std::size_t(y) * labels.width + x;
      mask[i] = labels.instances[i] == instance;
    }
  return mask;
}

class CocoWriter : public DataSetWriter {
 public:
  CocoWriter(const std::string& folder, const LabelledScene& scene)
      : m_folder(folder), m_scene(scene) {
    m_files.add_folder(folder + "/images");
  }

  void add(const LabelView& view, const Labels& labels, const std::string& picture) override {
    const std::string file = number_text(m_num_images) + ".png";
    m_files.add(m_folder + "/images/" + file, picture);
    m_images.push_back({{"id", m_num_images},
                        {"file_name", file},
                        {"width", labels.width},
                        {"height", labels.height},
                        {"view", view.name},
                        {"camera", camera_json(view.camera)}});
    for (std::size_t i = 0; i < labels.objects.size(); ++i)
      if (labels.objects[i].num_visible > 0) add_annotation(labels, static_cast<int>(i));
    ++m_num_images;
  }

  void finish() override {
    OrderedJson categories = OrderedJson::array();
    for (std::size_t i = 0; i < m_scene.classes.size(); ++i)
      categories.push_back({{"id", i + 1}, {"name", m_scene.classes[i]}, {"supercategory", ""}});
    const OrderedJson all = {{"info", {{"description", "Trivet"}, {"version", "1.0"}}},
                             {"licenses", OrderedJson::array()},
                             {"images", m_images},
                             {"categories", categories},
                             {"annotations", m_annotations}};
    m_files.add(m_folder + "/annotations.json", readable_json(all));
    m_files.commit();
  }

 private:
  void add_annotation(const Labels& labels, int object) {
    const ObjectLabel& label = labels.objects[object];
    const LabelledObject& what = m_scene.objects[object];
    const auto lengths =
        run_lengths(instance_mask(labels, object + 1), labels.width, labels.height);
    OrderedJson annotation = {
        {"id", m_annotations.size() + 1},
        {"image_id", m_num_images},
        {"category_id", what.class_id},
        {"iscrowd", 0},
        {"area", label.num_visible},
        {"bbox", visible_box_json(label.visible_box)},
        {"segmentation",
         {{"size", {labels.height, labels.width}}, {"counts", compressed_run_lengths(lengths)}}},
        {"bbox_amodal", whole_box_json(label.whole_box)},
        {"visibility", label.visible_share()},
        {"instance", object + 1},
        {"object", what.name}};
    if (!what.attributes.empty()) annotation["attributes"] = OrderedJson::parse(what.attributes);
    m_annotations.push_back(std::move(annotation));
  }

  std::string m_folder;
  const LabelledScene& m_scene;
  StagedFiles m_files;
  int m_num_images = 0;
  OrderedJson m_images = OrderedJson::array(), m_annotations = OrderedJson::array();
};

}  // namespace

std::unique_ptr<DataSetWriter> make_coco_writer(const std::string& folder,
                                                const LabelledScene& scene) {
  return std::make_unique<CocoWriter>(folder, scene);
}

}  // namespace trivet
