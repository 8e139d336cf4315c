// Images and textures of a glTF asset under construction. Private: exposes the JSON library.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/gltf/builder.h"
#include "core/io/model_folder.h"
#include "core/io/read_model.h"

namespace trivet {

namespace gltf {
inline constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;  // wraps of samplers
}

/// Use of an image by a material.
struct AddedTexture {
  std::string name;  // of the image's file
  SharedBytes bytes;
  int wrap_s = gltf::kRepeat, wrap_t = gltf::kRepeat;
  int set = 0;         // of texture coordinates
  GltfJson transform;  // of KHR_texture_transform; null: none
};

/// Places at which an image file that a model names may lie, the stated one first.
/// @param folder  of the file that names it, relative to the model's.
std::vector<std::filesystem::path> texture_places(const std::string& model, const std::string& name,
                                                  const std::string& folder);

class TextureAdder {
 public:
  /// @param notes  receives what is left out.
  TextureAdder(const std::string& model, const ImportLimits& limits, GltfBuilder& builder,
               std::vector<Sentence>& notes)
      : m_model(model), m_limits(limits), m_folder(model), m_builder(builder), m_notes(notes) {}

  /// An image file that the model names: looked up at the stated path, beside the file that names
  /// it, else beside the model, as models get moved and their paths break.
  /// @param folder  of the file that names it, relative to the model's.
  /// @return null, with a note: missing, outside the model's folder, or no image.
  SharedBytes file(const std::string& name, const std::string& folder = "");

  /// Equal samplers, images and textures are stored once. @return the reference to the texture.
  GltfJson add(const AddedTexture& texture);

  /// A note that is said once.
  void note(const Sentence& note);
  void note_missing(const std::string& name);

 private:
  SharedBytes found(const std::string& name, const std::string& folder) const;
  size_t add_once(std::map<GltfJson, size_t>& known, const char* list, const GltfJson& item);

  const std::string m_model;
  const ImportLimits& m_limits;
  const ModelFolder m_folder;
  GltfBuilder& m_builder;
  std::vector<Sentence>& m_notes;
  std::map<std::string, SharedBytes> m_files;
  std::map<GltfJson, size_t> m_samplers, m_textures;
};

}  // namespace trivet
