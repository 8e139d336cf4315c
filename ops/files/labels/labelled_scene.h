// A scene for labelled images: what to draw, and what each object is. Start here.
#pragma once

#include <functional>
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
  // Targets of one model, scale and up axis share one; counted from 1 in the order of the scene.
  // 0: no target, such as fixed furniture and distractors.
  int model_id = 0;
  std::string attributes;  // a JSON object; empty: none
  Pose pose;

  bool is_target() const { return model_id > 0; }
};

/// A model as the poses place it: in metres, turned up.
struct LabelledModel {
  std::shared_ptr<const Model> model;
  Affine metres_from_file;
};

struct LabelledScene {
  PictureScene picture;  // the placed objects, in the scene's order
  std::vector<LabelledObject> objects;
  std::vector<std::string> classes;            // sorted, each once; or those of the set
  std::vector<LabelledModel> models;           // by model_id - 1; empty: those of the set
  std::map<const Model*, PictureMesh> meshes;  // what `picture` refers to

  LabelledScene() = default;
  LabelledScene(const LabelledScene&) = delete;
  LabelledScene(LabelledScene&&) = default;  // moved maps keep their nodes
  LabelledScene& operator=(LabelledScene&&) = default;
};

/// Ids that hold over a whole set of scenes, rather than being counted in one.
struct LabelIds {
  std::vector<std::string> classes;               // by class_id - 1
  std::function<int(const Object&)> model_id_of;  // 0: no target
};

/// @param layout  what made the scene: classes and attributes of objects, by the names that its
/// operations left them; a duplicate has those of its original, and refused operations have no part
/// in it. Without a class: the name of the model's file.
/// @param classes  of objects by their names, before those of the layout.
/// @param ids  of a set; null: counted here. Then targets are what is not fixed; everything, where
/// all is.
/// The scene's models must outlive the result.
LabelledScene labelled_scene(const Scene& scene, const Layout& layout,
                             const std::map<std::string, std::string>& classes = {},
                             const LabelIds* ids = nullptr);

/// The class of an object that states none: the name of its model's file.
std::string class_of_model(const std::string& model_path);

}  // namespace trivet
