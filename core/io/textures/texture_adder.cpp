#include "core/io/textures/texture_adder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/io/opened_files.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// Null: not there, too large, or no image. Only images are passed on, whatever an untrusted file's
// path points to.
SharedBytes image_in(const fs::path& file, const ImportLimits& limits) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size == 0 || size > limits.max_file_bytes) return nullptr;
  std::string bytes(size, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size))) return nullptr;
  if (image_type(bytes).empty()) return nullptr;
  return std::make_shared<const std::string>(std::move(bytes));
}

}  // namespace

SharedBytes TextureAdder::file(const std::string& name, const std::string& folder) {
  const auto [entry, is_new] = m_files.try_emplace(folder + "\n" + name, nullptr);
  if (!is_new) return entry->second;
  entry->second = found(with_slashes(name), folder);
  if (!entry->second) note_missing(name);
  return entry->second;
}

std::vector<fs::path> texture_places(const std::string& model, const std::string& name,
                                     const std::string& folder) {
  const fs::path home = fs::path(model).parent_path(), beside = home / folder;
  const fs::path own = fs::path(name).filename();
  return {beside / name,          home / name, beside / own, home / own, beside / "textures" / own,
          home / "textures" / own};
}

SharedBytes TextureAdder::found(const std::string& name, const std::string& folder) const {
  for (const fs::path& candidate : texture_places(m_model, name, folder))
    if (m_folder.has(candidate)) {
      note_opened(m_model, {candidate.string()});
      if (SharedBytes bytes = image_in(candidate, m_limits)) return bytes;
    }
  return nullptr;
}

GltfJson TextureAdder::add(const AddedTexture& texture) {
  const GltfJson sampler = {{"wrapS", texture.wrap_s}, {"wrapT", texture.wrap_t}};
  const std::string type = image_type(*texture.bytes);
  const size_t image = m_builder.add_image(
      {{"name", fs::path(with_slashes(texture.name)).stem().string()}, {"mimeType", type}},
      texture.bytes);
  GltfJson shown = {{"sampler", add_once(m_samplers, "samplers", sampler)}};
  if (type == "image/webp") {
    shown["extensions"]["EXT_texture_webp"]["source"] = image;
    m_builder.use_extension("EXT_texture_webp", true);
  } else {
    shown["source"] = image;
  }
  GltfJson out = {{"index", add_once(m_textures, "textures", shown)}};
  if (texture.set > 0) out["texCoord"] = texture.set;
  if (!texture.transform.is_null()) {
    out["extensions"]["KHR_texture_transform"] = texture.transform;
    m_builder.use_extension("KHR_texture_transform", false);
  }
  return out;
}

size_t TextureAdder::add_once(std::map<GltfJson, size_t>& known, const char* list,
                              const GltfJson& item) {
  const auto [entry, is_new] = known.try_emplace(item, 0);
  if (is_new) entry->second = m_builder.add(list, item);
  return entry->second;
}

void TextureAdder::note(const Sentence& note) {
  const std::string text = in_english(note);
  const auto says_it = [&](const Sentence& other) { return in_english(other) == text; };
  if (std::none_of(m_notes.begin(), m_notes.end(), says_it)) m_notes.push_back(note);
}

void TextureAdder::note_missing(const std::string& name) {
  note(
      say("left out: the texture \"%1\", missing, outside the model's folder, or neither PNG, JPEG "
          "nor WebP",
          name));
}

}  // namespace trivet
