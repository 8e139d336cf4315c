#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/io/colour.h"
#include "core/io/obj/materials.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

using Numbers = std::vector<float>;

/// Properties of a material as its lines come.
struct MtlMaterial {
  std::string name;
  FileMaterial file;
  std::optional<float> roughness, exponent, opacity;
  bool has_highlight = false;
};

// Stated, else derived from the highlight's exponent (alpha = roughness squared), provided the
// highlight has a colour.
float roughness_of(const MtlMaterial& m, float otherwise) {
  if (m.roughness) return unit_interval(*m.roughness, otherwise);
  if (!m.exponent || !(*m.exponent > 1) || !m.has_highlight) return otherwise;
  return unit_interval(std::pow(2.0f / (*m.exponent + 2.0f), 0.25f), otherwise);
}

FileMaterial finished(MtlMaterial m) {
  Material& out = m.file.surface;
  out.name = m.name;
  out.roughness = roughness_of(m, out.roughness);
  // Opacity 0 is a common exporter's error about the meaning of `d`, not an invisible object.
  if (m.opacity && *m.opacity > 0) out.base_colour[3] = unit_interval(*m.opacity, 1.0f);
  return m.file;
}

// Options before the name of a texture, with the most numbers or words that follow each.
constexpr std::pair<std::string_view, int> kOptions[] = {
    {"-blendu", 1}, {"-blendv", 1}, {"-boost", 1},   {"-mm", 2},        {"-texres", 1},
    {"-clamp", 1},  {"-bm", 1},     {"-imfchan", 1}, {"-type", 1},      {"-cc", 1},
    {"-o", 3},      {"-s", 3},      {"-t", 3},       {"-colorspace", 1}};

int arguments_of(std::string_view option) {
  for (const auto& [name, count] : kOptions)
    if (equal_words(option, name)) return count;
  return 0;
}

/// A line such as `-s 2 2 1 -clamp on my wood.png`; names may have blanks.
FileTexture texture_of(std::string_view line, const std::string& folder) {
  FileTexture out;
  out.folder = folder;
  while (true) {
    std::string_view rest = line;
    const std::string_view option = next_word(rest);
    const int most = arguments_of(option);
    if (most == 0) break;
    std::vector<double> numbers;
    for (int i = 0; i < most; ++i) {
      std::string_view after = rest;
      const std::string_view word = next_word(after);
      const auto number = number_from(word);
      // Behind -o, -s and -t the second and third number may be left out.
      if (most == 3 && !number) break;
      if (equal_words(option, "-clamp")) out.clamps = equal_words(word, "on");
      numbers.push_back(number.value_or(0));
      rest = after;
    }
    for (size_t i = 0; most == 3 && i < std::min<size_t>(2, numbers.size()); ++i)
      if (equal_words(option, "-s"))
        out.scale[i] = static_cast<float>(numbers[i]);
      else if (equal_words(option, "-o"))
        out.offset[i] = static_cast<float>(numbers[i]);
    line = rest;
  }
  std::string_view name = trimmed(line);
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
    name = name.substr(1, name.size() - 2);
  out.name = name;
  return out;
}

class MtlReader {
 public:
  MtlReader(const std::string& folder, std::map<std::string, FileMaterial>& materials,
            std::vector<Sentence>& notes)
      : m_folder(folder), m_materials(materials), m_notes(notes) {}

  void read(std::string_view text) {
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) read_line(line);
    end_material();
    std::string names;
    for (const std::string& key : m_unknown) names += (names.empty() ? "" : ", ") + key;
    if (!names.empty()) note_once(m_notes, say("left out: lines of the .mtl file: %1", names));
  }

 private:
  void read_line(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word.empty() || word[0] == '#') return;
    const std::string key = lower_case(word);
    m_word = word;
    if (key == "newmtl") {
      end_material();
      m_material.emplace().name = trimmed(line);
    } else if (!m_material) {
      note_unknown(word);
    } else if (!read_colour(key, line) && !read_number(key, line) && !read_texture(key, line) &&
               !is_silent(key)) {
      note_unknown(word);
    }
  }

  void end_material() {
    if (m_material) m_materials.try_emplace(m_material->name, finished(*m_material));
    m_material.reset();
  }

  // Three numbers, or one for all; nullopt: "spectral" and "xyz" have others.
  std::optional<std::array<float, 3>> colour(std::string_view line) {
    std::array<float, 3> out{};
    std::string_view word = next_word(line);
    if (equal_words(word, "spectral") || equal_words(word, "xyz")) {
      note_once(m_notes, say("left out: colours of the .mtl file by \"%1\"", std::string(word)));
      return std::nullopt;
    }
    for (size_t i = 0; i < 3; ++i) {
      const auto number = number_from(word);
      if (!number && i == 1) out[1] = out[2] = out[0];
      if (!number && i > 0) break;
      if (!number) return note_unknown(m_word), std::nullopt;
      out[i] = static_cast<float>(*number);
      word = next_word(line);
    }
    return out;
  }

  bool read_colour(const std::string& key, std::string_view line) {
    if (key != "kd" && key != "ks" && key != "ke") return false;
    const auto found = colour(line);
    if (!found) return true;
    Material& surface = m_material->file.surface;
    for (size_t i = 0; i < 3; ++i) {
      const float value = (*found)[i];
      if (key == "kd")
        surface.base_colour[i] = linear_from_srgb(unit_interval(value, surface.base_colour[i]));
      else if (key == "ke")
        m_material->file.emission[i] = linear_from_srgb(unit_interval(value, 0));
      else
        m_material->has_highlight |= value > 0;
    }
    return true;
  }

  bool read_number(const std::string& key, std::string_view line) {
    if (key != "ns" && key != "d" && key != "tr" && key != "pr" && key != "pm") return false;
    std::string_view word = next_word(line);
    if (equal_words(word, "-halo")) word = next_word(line);
    const auto number = number_from(word);
    if (!number) return note_unknown(m_word), true;
    const auto value = static_cast<float>(*number);
    if (key == "ns") m_material->exponent = value;
    if (key == "d") m_material->opacity = value;
    if (key == "tr" && !m_material->opacity) m_material->opacity = 1 - value;
    if (key == "pr") m_material->roughness = value;
    if (key == "pm") m_material->file.surface.metallic = unit_interval(value, 0);
    return true;
  }

  bool read_texture(const std::string& key, std::string_view line) {
    FileMaterial& file = m_material->file;
    if (key == "map_kd") {
      file.base_colour = texture_of(line, m_folder);
    } else if (key == "map_ke") {
      file.emissive = texture_of(line, m_folder);
    } else if (key == "norm" || key == "map_kn") {
      file.normal = texture_of(line, m_folder);
    } else if (key == "map_d") {
      file.cut_by_texture = true;
    } else {
      return note_map(key, line);
    }
    return true;
  }

  bool note_map(const std::string& key, std::string_view line) {
    static constexpr std::pair<std::string_view, const char*> kMaps[] = {
        {"map_bump", TRIVET_SENTENCE("bump maps")},
        {"bump", TRIVET_SENTENCE("bump maps")},
        {"map_pr", TRIVET_SENTENCE("maps of roughness")},
        {"map_pm", TRIVET_SENTENCE("maps of metalness")},
        {"map_ks", TRIVET_SENTENCE("maps of specular colour")},
        {"map_ka", TRIVET_SENTENCE("maps of ambient colour")},
        {"map_ns", TRIVET_SENTENCE("maps of gloss")},
        {"disp", TRIVET_SENTENCE("displacement maps")},
        {"map_disp", TRIVET_SENTENCE("displacement maps")},
        {"decal", TRIVET_SENTENCE("decals")},
        {"refl", TRIVET_SENTENCE("reflection maps")},
        {"map_refl", TRIVET_SENTENCE("reflection maps")}};
    for (const auto& [name, what] : kMaps) {
      if (key != name) continue;
      note_once(m_notes, say("left out: %1", Sentence(what)));
      m_material->file.unread.push_back(texture_of(line, m_folder));
      return true;
    }
    return false;
  }

  // Keys that have no meaning here, and are left out by every reader of geometry.
  static bool is_silent(const std::string& key) {
    static constexpr std::string_view kSilent[] = {"ka", "tf", "ni",  "illum",  "sharpness",
                                                   "ps", "pc", "pcr", "map_aat"};
    return std::find(std::begin(kSilent), std::end(kSilent), key) != std::end(kSilent);
  }

  void note_unknown(std::string_view word) {
    constexpr size_t kMost = 8;
    std::string key(word.substr(0, 20));
    for (char& c : key)
      if (c < ' ' || c == '\x7f' || static_cast<unsigned char>(c) >= 0x80) c = '?';
    if (m_unknown.size() < kMost &&
        std::find(m_unknown.begin(), m_unknown.end(), key) == m_unknown.end())
      m_unknown.push_back(key);
  }

  const std::string m_folder;
  std::map<std::string, FileMaterial>& m_materials;
  std::vector<Sentence>& m_notes;
  std::optional<MtlMaterial> m_material;
  std::string_view m_word;  // that the line begins with
  std::vector<std::string> m_unknown;
};

}  // namespace

void read_mtl(std::string_view text, const std::string& folder,
              std::map<std::string, FileMaterial>& materials, std::vector<Sentence>& notes) {
  MtlReader(folder, materials, notes).read(text);
}

}  // namespace trivet
