#include "ops/files/labels/coco_images.h"

#include "ops/files/labels/data_sets.h"

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

}  // namespace

void CocoImages::add(const LabelView& view, const Labels& labels, const std::string& file) {
  m_images.push_back({{"id", m_next_image},
                      {"file_name", file},
                      {"width", labels.width},
                      {"height", labels.height},
                      {"view", view.name},
                      {"camera", camera_json(view.camera)}});
  for (std::size_t i = 0; i < labels.objects.size(); ++i)
    if (labels.objects[i].num_visible > 0 && m_scene.objects[i].is_target())
      add_annotation(view, labels, static_cast<int>(i));
  ++m_next_image;
}

void CocoImages::add_annotation(const LabelView& view, const Labels& labels, int object) {
  const ObjectLabel& label = labels.objects[object];
  const LabelledObject& what = m_scene.objects[object];
  const auto lengths = run_lengths(instance_mask(labels, object + 1), labels.width, labels.height);
  OrderedJson annotation = {
      {"id", m_next_annotation++},
      {"image_id", m_next_image},
      {"category_id", m_class_ids.empty() ? what.class_id : m_class_ids[what.class_id - 1]},
      {"iscrowd", 0},
      {"area", label.num_visible},
      {"bbox", visible_box_json(label.visible_box)},
      {"segmentation",
       {{"size", {labels.height, labels.width}}, {"counts", compressed_run_lengths(lengths)}}},
      {"bbox_amodal", whole_box_json(label.whole_box)},
      {"visibility", label.visible_share()},
      {"instance", object + 1},
      {"object", what.name},
      {"camera_from_object", pose_json(view.camera, what.pose)}};
  if (!what.attributes.empty()) annotation["attributes"] = OrderedJson::parse(what.attributes);
  m_annotations.push_back(std::move(annotation));
}

OrderedJson coco_categories(const std::vector<std::string>& classes) {
  OrderedJson out = OrderedJson::array();
  for (std::size_t i = 0; i < classes.size(); ++i)
    out.push_back({{"id", i + 1}, {"name", classes[i]}, {"supercategory", ""}});
  return out;
}

OrderedJson coco_head() {
  return {{"info", {{"description", "Trivet"}, {"version", "1.0"}}},
          {"licenses", OrderedJson::array()}};
}

}  // namespace trivet
