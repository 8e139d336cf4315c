// Views of a scene as data sets: COCO and BOP.
#pragma once

#include <memory>
#include <string>

#include "ops/files/labels/label_json.h"

namespace trivet {

/// Takes one view after another, and at the end has what describes them all. Files get their names
/// together in finish(): without it, as when a disk is full, nothing is left.
class DataSetWriter {
 public:
  virtual ~DataSetWriter() = default;
  /// @param picture  the bytes of a PNG file of the view.
  /// @throws Error (Environment) when a file cannot be written.
  virtual void add(const LabelView& view, const Labels& labels, const std::string& picture) = 0;
  virtual void finish() = 0;
};

/// COCO's instances: FOLDER/annotations.json and FOLDER/images/000000.png, ... An annotation per
/// target that is seen: box and compressed run lengths of its visible pixels; beside COCO's keys
/// "bbox_amodal", "visibility", "instance", "camera_from_object" and "attributes"; of an image
/// "camera". A set that is there gets the views as further ones; its ids stay. @see [Lin 2014].
/// The scene must outlive it.
/// @throws Error (BadInput) when the folder has another annotations.json.
std::unique_ptr<DataSetWriter> make_coco_writer(const std::string& folder,
                                                const LabelledScene& scene);

/// BOP: FOLDER/000000/{rgb,depth,mask,mask_visib}, scene_camera.json, scene_gt.json and
/// scene_gt_info.json of the targets, see bop_scene.h; FOLDER/models, see bop_models.h, and
/// FOLDER/camera.json. A set that is there gets the next scene, and the models that it has keep
/// their ids. @see [Hodan 2018]
/// @param depth_unit  metres per unit of the depth images.
/// @throws Error (BadInput) when the folder has another models_info.json.
std::unique_ptr<DataSetWriter> make_bop_writer(const std::string& folder,
                                               const LabelledScene& scene, double depth_unit);

/// Run lengths of a mask, column by column, beginning with what is not in it.
/// @param mask  height x width, row by row.
std::vector<std::uint32_t> run_lengths(const std::vector<bool>& mask, int width, int height);
/// As COCO's text: differences in pieces of 5 bits.
std::string compressed_run_lengths(const std::vector<std::uint32_t>& lengths);

}  // namespace trivet
