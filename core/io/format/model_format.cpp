#include "core/io/format/model_format.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/cad_format.h"
#include "core/io/format/other_formats.h"
#include "core/io/off/read_off.h"
#include "core/io/stl/read_stl.h"
#include "core/io/text/words.h"
#include "core/io/threemf/read_3mf.h"

namespace trivet {
namespace {

// Behind blanks, empty lines and a byte order mark, in lower case.
std::string beginning(std::string_view bytes, size_t length) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  while (!bytes.empty() && (is_blank(bytes[0]) || is_line_end(bytes[0]))) bytes.remove_prefix(1);
  return lower_case(bytes.substr(0, length));
}

// Lines that begin with these words, among the first ones.
bool looks_like_obj(std::string_view head) {
  TextLines lines(head);
  int vertices = 0, others = 0;
  for (std::string_view line; vertices < 3 && lines.next(line);) {
    if (line.find('\0') != line.npos) return false;
    const std::string_view key = next_word(line);
    if (key.empty() || key[0] == '#') continue;
    static constexpr std::string_view kKeys[] = {"mtllib", "usemtl", "o",  "g", "s",
                                                 "vt",     "vn",     "vp", "f"};
    if (equal_words(key, "v") && number_from(next_word(line)))
      ++vertices;
    else if (std::none_of(std::begin(kKeys), std::end(kKeys),
                          [&](std::string_view k) { return equal_words(key, k); }))
      ++others;
  }
  return vertices > 0 && others == 0;
}

// glTF 1 and 2 as text: an object with an "asset", which may stand behind long lists.
bool is_gltf_text(std::string_view begin, std::string_view head, const std::string& extension) {
  if (!begin.starts_with("{")) return false;
  return extension == ".gltf" || extension == ".glb" || head.find("\"asset\"") != head.npos;
}

// Names that leave to the content what it is; others are left to assimp.
bool may_be_own(const std::string& extension) {
  static constexpr std::string_view kNames[] = {"",      ".obj", ".stl", ".ply", ".off", ".3mf",
                                                ".gltf", ".glb", ".bin", ".dat", ".txt", ".tmp"};
  return std::find(std::begin(kNames), std::end(kNames), extension) != std::end(kNames) ||
         is_told_by_content(extension);
}

bool begins_with_any(std::string_view head, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return head.starts_with(beginning); });
}

bool is_packed(std::string_view head) {
  return begins_with_any(head, {"BZh", "\xfd\x37zXZ", "7z\xbc\xaf", "Rar!"});
}

// Some formats that assimp reads are ZIP archives, too.
bool is_zip_of_others(std::string_view head, const std::string& extension) {
  return begins_with_any(head, {"PK\3\4", "PK\5\6"}) && extension != ".3mf" && !holds_3mf(head) &&
         (extension == ".zip" || may_be_own(extension));
}

bool is_picture(std::string_view head) {
  return begins_with_any(head, {"\x89PNG\r\n", "\xff\xd8\xff", "GIF8", "%PDF-"});
}

bool is_cad(std::string_view begin) {
  return begins_with_any(begin, {"iso-10303-21", "dbrep_drawableshape", "cascade topology"});
}

}  // namespace

std::string head_of(const std::string& path) {
  std::string head(kHeadBytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(in.gcount()));
  return head;
}

ModelFormat model_format(std::string_view head, std::uintmax_t size, const std::string& extension) {
  const std::string begin = beginning(head, 8);
  if (begin.starts_with("ply") && begin.size() > 3 && (is_blank(begin[3]) || is_line_end(begin[3])))
    return ModelFormat::Ply;
  if (head.starts_with("PK\3\4") && (extension == ".3mf" || holds_3mf(head)))
    return ModelFormat::ThreeMf;
  if (head.starts_with("glTF") || is_gltf_text(begin, head, extension)) return ModelFormat::Gltf;
  if (begin.starts_with("{") || tells_other_format(head, size)) return ModelFormat::Other;
  if (may_be_own(extension) && is_binary_stl(head, size)) return ModelFormat::Stl;
  if (is_text_stl(head)) return ModelFormat::Stl;
  if (is_text_off(head)) return ModelFormat::Off;
  if (may_be_own(extension) && looks_like_obj(head)) return ModelFormat::Obj;
  if (extension == ".obj") return ModelFormat::Obj;
  if (extension == ".stl") return ModelFormat::Stl;
  if (extension == ".ply") return ModelFormat::Ply;
  if (extension == ".off") return ModelFormat::Off;
  if (extension == ".gltf" || extension == ".glb") return ModelFormat::Gltf;
  if (extension == ".3mf") return ModelFormat::ThreeMf;
  return ModelFormat::Other;
}

std::optional<Sentence> placeholder(std::string_view head) {
  const std::string begin = beginning(head, 256);
  if (begin.starts_with("version https://git-lfs"))
    return TRIVET_SENTENCE(
        "is a pointer of Git LFS, not the file itself; accepted: the file that it stands for "
        "(git lfs pull)");
  const bool is_answer = begin.starts_with("<?xml") && begin.find("<error>") != begin.npos;
  if (begin.starts_with("<!doctype html") || begin.starts_with("<html") || is_answer)
    return TRIVET_SENTENCE("is a web page; accepted: the file that the page offers");
  return std::nullopt;
}

void check_is_model(const std::string& path, std::string_view head) {
  if (const auto what = placeholder(head)) bad_file(path, *what);
  if (cad_format(path).empty() && is_cad(beginning(head, 32)))
    bad_file(path, "is a CAD file under another name; accepted: a name in .step, .iges or .brep");
  if (head.starts_with("\x1f\x8b"))
    bad_file(path, "is packed by gzip; accepted: the unpacked file");
  if (is_packed(head) || is_zip_of_others(head, lower_extension(path)))
    bad_file(path, "is a packed file; accepted: the unpacked model");
  if (is_picture(head)) bad_file(path, "is a picture or a page, not a model");
}

}  // namespace trivet
