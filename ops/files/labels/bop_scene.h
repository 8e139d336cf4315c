// One scene of a BOP set, view after view. Private.
#pragma once

#include <functional>

#include "ops/files/labels/label_json.h"

namespace trivet {

/// Files of a scene, by names in its folder: rgb/, depth/, mask/ and mask_visib/ of the targets;
/// at the end scene_camera.json, scene_gt.json and scene_gt_info.json. Boxes are those of
/// bop_toolkit: x, y of the first pixel, then last minus first, so that one pixel has width 0; all
/// -1 where nothing is seen.
class BopScene {
 public:
  using Sink = std::function<void(const std::string& name, const std::string& bytes)>;
  /// @param depth_unit  metres. @param ids  obj_id by model_id - 1; empty: the same.
  BopScene(const LabelledScene& scene, double depth_unit, Sink sink, std::vector<int> ids = {});

  /// @param picture  the bytes of a PNG file; empty: none.
  void add(const LabelView& view, const Labels& labels, const std::string& picture);
  void finish();

 private:
  void add_target(const LabelView& view, const Labels& labels, std::size_t object);

  const LabelledScene& m_scene;
  double m_unit;
  Sink m_sink;
  std::vector<int> m_ids;
  int m_num_images = 0;
  OrderedJson m_cameras = OrderedJson::object(), m_poses = OrderedJson::object(),
              m_infos = OrderedJson::object();
};

inline constexpr double kMillimetres = 1000;  // of a metre: BOP's unit

OrderedJson vector_json(const Vec3& v);

/// camera.json of a set.
OrderedJson bop_camera_json(const PinholeCamera& camera, double depth_unit);

}  // namespace trivet
