// A scene for labelled images: what to draw, and what each object is. Start here.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/picture/scene.h"
#include "core/scene/scene.h"
#include "ops/files/layout/layout.h"

namespace trivet {

struct LabelledObject {
  std::string name;
  std::string class_name;
  int class_id = 0;  // 1 + index into the classes
  // Objects of one model, scale and up axis share one; counted from 1 in the order of the scene.
  int model_id = 0;
  std::string attributes;  // a JSON object; empty: none
  Pose pose;
};

/// A model as the poses place it: in metres, turned up.
struct LabelledModel {
  std::shared_ptr<const Model> model;
  Affine metres_from_file;
};

struct LabelledScene {
  PictureScene picture;  // the placed objects, in the scene's order
  std::vector<LabelledObject> objects;
  std::vector<std::string> classes;            // sorted, each once
  std::vector<LabelledModel> models;           // by model_id - 1
  std::map<const Model*, PictureMesh> meshes;  // what `picture` refers to

  LabelledScene() = default;
  LabelledScene(const LabelledScene&) = delete;
  LabelledScene(LabelledScene&&) = default;  // moved maps keep their nodes
  LabelledScene& operator=(LabelledScene&&) = default;
};

/// @param layout  what made the scene: classes and attributes of objects, by the names that its
/// operations left them; a duplicate has those of its original, and refused operations have no part
/// in it. Without a class: the name of the model's file.
/// @param classes  of objects by their names, before those of the layout.
/// The scene's models must outlive the result.
LabelledScene labelled_scene(const Scene& scene, const Layout& layout,
                             const std::map<std::string, std::string>& classes = {});

}  // namespace trivet
