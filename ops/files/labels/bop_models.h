// Models of a BOP set: PLY files with normals and colours or a texture, and models_info.json.
// Private.
#pragma once

#include <string>

#include "ops/files/labels/label_json.h"

namespace trivet {

struct BopModel {
  std::string ply;             // millimetres; a texture is named obj_000017.png, as the number says
  std::string texture;         // PNG; empty: the PLY has colours
  OrderedJson info;            // of models_info.json
  bool is_revolution = false;  // "symmetries_continuous" was found, not given
};

/// Vertices with normals; with "texture_u", "texture_v" (from below, as OpenGL counts) where one
/// image colours all of the model, else with colours, in which further textures are sampled.
/// Diameter, box, and symmetries as given, else found, see symmetry.h, where no image or vertex
/// colour may tell sides apart.
/// @param symmetries  JSON {"continuous": [{"axis", "offset"}], "discrete": [[16 numbers]]},
/// metres; empty: none given.
BopModel bop_model(const LabelledModel& model, int id, const std::string& symmetries = "");

/// obj_000017
std::string bop_model_name(int id);

}  // namespace trivet
