// Pictures and labels of a scene that has been made: from its poses, without laying it out again.
#pragma once

#include <functional>

#include "apps/farm/pictures/looks.h"
#include "apps/farm/recipe/views.h"
#include "apps/farm/store/run_file.h"
#include "ops/files/layout/scene_of_layout.h"

namespace trivet::farm {

/// The bytes of a PNG file of a scene, with so many samples a pixel.
using DrawPicture =
    std::function<std::string(const PictureScene& scene, const PinholeCamera& camera, int samples)>;

/// Input of pictures.
struct PictureWork {
  std::string folder;  // the batch of the scenes
  BatchRun scenes;
  Views views;
  // Called once in every process that draws pictures by OpenGL. Null: they are drawn by rays.
  std::function<DrawPicture()> make_opengl;
  UnitFormat form = UnitFormat::Tar;           // of data sets their own members instead
  std::shared_ptr<Environments> environments;  // of the look; read when they are needed
};

/// Pictures and labels of scene k: its JSON with "views", [{"name", "camera"}], and for each view
/// members "K.VIEW.png" (the picture), "K.VIEW.depth.png", ".instances.png", ".classes.png",
/// ".normals.png" as wanted, and, with labels, "K.VIEW.labels.json". Scenes that are not "ok" have
/// no views. Of a BOP set the members are those of BopScene, of a COCO set "VIEW.png" and
/// "annotations.json". Ids are those of label_ids(). By rays in the calling thread; labels are the
/// same bits on any machine, pictures where the mathematical library is the same.
/// @param scenes  of the folder of the work.
/// @param opengl  draws the pictures instead, of which the bytes depend on the driver, too; or
/// null.
/// @throws Error (BadInput) when the batch has no scene k, or poses that do not fit.
SceneMembers make_pictures(const PictureWork& work, SceneReader& scenes, const Recipe& recipe,
                           const LoadedModels& models, const PhiloxKey& key, std::uint64_t k,
                           const DrawPicture& opengl = nullptr);

}  // namespace trivet::farm
