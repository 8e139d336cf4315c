// Images and annotations of a COCO set. Private.
#pragma once

#include "ops/files/labels/label_json.h"

namespace trivet {

/// Entries of annotations.json, view after view: an annotation per target that is seen.
class CocoImages {
 public:
  /// @param first_image, first_annotation  their ids.
  /// @param class_ids  category_id by class_id - 1; empty: the same.
  explicit CocoImages(const LabelledScene& scene, std::int64_t first_image = 0,
                      std::int64_t first_annotation = 1, std::vector<int> class_ids = {})
      : m_scene(scene),
        m_next_image(first_image),
        m_next_annotation(first_annotation),
        m_class_ids(std::move(class_ids)) {}

  /// @param file  of the image, relative to images/.
  void add(const LabelView& view, const Labels& labels, const std::string& file);
  const OrderedJson& images() const { return m_images; }
  const OrderedJson& annotations() const { return m_annotations; }

 private:
  void add_annotation(const LabelView& view, const Labels& labels, int object);

  const LabelledScene& m_scene;
  std::int64_t m_next_image, m_next_annotation;
  std::vector<int> m_class_ids;
  OrderedJson m_images = OrderedJson::array(), m_annotations = OrderedJson::array();
};

/// "categories": a class is known by its place.
OrderedJson coco_categories(const std::vector<std::string>& classes);
/// "info" and "licenses" of a set.
OrderedJson coco_head();

}  // namespace trivet
