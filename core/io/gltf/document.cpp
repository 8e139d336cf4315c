#include "core/io/gltf/document.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/base64.h"
#include "core/io/format/model_format.h"
#include "core/io/gltf/extensions.h"
#include "core/io/gltf/glb_container.h"
#include "core/io/gltf/structure.h"
#include "core/io/json.h"
#include "core/io/model_folder.h"
#include "core/io/opened_files.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

constexpr JsonLimits kGltfJsonLimits{.max_depth = 200};

std::string whole_file(const fs::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  if (fs::is_directory(path, error)) bad_input("%1: is a folder, not a file", path.string());
  const auto bytes = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
  if (error || bytes == 0) bad_input("%1: is missing or empty", path.string());
  if (bytes > max_bytes)
    bad_input("%1: %2 bytes, more than the limit of %3", path.string(), bytes, max_bytes);
  std::string out(bytes, '\0');
  if (!std::ifstream(path, std::ios::binary).read(out.data(), static_cast<long>(bytes)))
    bad_input("%1: cannot be read", path.string());
  return out;
}

// By its content: names lie, and sessions rename their start file. The name counts where the
// content says nothing.
bool is_glb(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error))  // opening a pipe would wait
    return lower_extension(path) == ".glb";
  std::array<char, 64> begin{};
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), begin.size());
  const std::string_view head(begin.data(), static_cast<size_t>(in.gcount()));
  if (head.starts_with("glTF")) return true;
  const size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool text = first != head.npos && (head[first] == '{' || head.starts_with("\xff\xfe"));
  return !text && lower_extension(path) == ".glb";
}

// glTF is UTF-8; a byte order mark may be ignored.
std::string without_mark(const std::string& path, std::string text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    bad_input("%1: is UTF-16 text; accepted: glTF in UTF-8", path);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

bool is_data_uri(std::string_view uri) { return lower_case(uri.substr(0, 5)) == "data:"; }

// "data:application/octet-stream;base64,AAAA", or percent-encoded bytes behind the comma.
std::string bytes_of_data_uri(const std::string& uri) {
  const size_t comma = uri.find(',');
  if (comma == uri.npos) bad_input("a data URI has no comma before its data");
  std::string data = uri.substr(comma + 1);
  if (data.find('%') != data.npos) data = decoded_uri(data);
  return lower_case(uri.substr(0, comma)).ends_with(";base64") ? decoded_base64(data) : data;
}

class DocumentReader {
 public:
  DocumentReader(const std::string& path, const ImportLimits& limits)
      : m_path(path), m_limits(limits), m_folder(path) {}

  GltfDocument read(GltfJson json) {
    m_document.json = std::move(json);
    check_structure(m_document.json);
    gltf::check_required(m_path, m_document.json);
    read_buffers(is_glb(m_path) ? read_glb_binary(m_path) : "");
    move_views();
    read_images();
    return std::move(m_document);
  }

 private:
  std::string bytes_of_uri(const std::string& uri) const {
    if (is_data_uri(uri)) return bytes_of_data_uri(uri);
    const fs::path path = file_of_uri(uri);
    note_opened(m_path, {path.string()});
    std::string bytes = whole_file(path, m_limits.max_file_bytes);
    if (const auto what = placeholder(bytes))
      bad_file(m_path, "names \"%1\", which %2", printable(uri, 100), *what);
    return bytes;
  }

  // Names should be percent-encoded, and often are not.
  fs::path file_of_uri(const std::string& uri) const {
    const fs::path folder = fs::path(m_path).parent_path();
    for (const std::string& name : {decoded_uri(uri), uri, with_slashes(decoded_uri(uri))}) {
      // ".." goes up by name, as in addresses, even from a folder that is not there.
      fs::path file = folder / fs::path(name).lexically_normal();
      const bool is_whole = name.find('\0') == name.npos;
      if (!is_whole || !m_folder.holds(file)) bad_file(m_path, outside_folder(uri));
      if (m_folder.has(file)) return file;
    }
    bad_file(m_path, "names \"%1\", which is missing", printable(uri, 100));
  }

  void read_buffers(const std::string& chunk) {
    const GltfJson& buffers = member(m_document.json, "buffers");
    for (size_t i = 0; i < buffers.size(); ++i) {
      const GltfJson& uri = member(buffers[i], "uri");
      const bool placeholder = gltf::is_placeholder(buffers[i]) || (!uri.is_string() && i > 0);
      std::string bytes;
      if (uri.is_string() && !placeholder) bytes = bytes_of_uri(uri.get<std::string>());
      if (!uri.is_string() && i == 0) bytes = chunk;
      const size_t length = placeholder ? 0 : index_from(member(buffers[i], "byteLength"));
      if (length > bytes.size())
        bad_input("buffer %1 has %2 bytes, expected %3", i, bytes.size(), length);
      m_starts.push_back(m_document.binary.size());
      m_ends.push_back(m_starts.back() + length);
      m_document.binary.append(bytes, 0, length);
      m_document.binary.resize((m_document.binary.size() + 3) / 4 * 4);
      if (m_document.binary.size() > m_limits.max_file_bytes)
        bad_input("the buffers exceed the limit");
    }
  }

  // Merges all views into the single buffer. A compressed one then has the range of its compressed
  // bytes.
  void move_views() {
    if (!m_document.json.contains("bufferViews")) return;
    for (GltfJson& view : m_document.json["bufferViews"]) {
      const GltfJson& compression = gltf::compression_of(view);
      const bool own = compression.is_null() || !compression.contains("buffer");
      const auto [offset, length] = range_in_buffer(own ? view : compression);
      view["buffer"] = 0;
      view["byteOffset"] = offset;
      view["byteLength"] = length;
      if (own) continue;
      for (auto& [name, content] : view["extensions"].items())
        if (content.is_object())
          for (const char* const key : {"buffer", "byteOffset", "byteLength"}) content.erase(key);
    }
    m_document.json.erase("buffers");
  }

  std::pair<size_t, size_t> range_in_buffer(const GltfJson& view) const {
    const size_t buffer = index_from(member(view, "buffer"));
    if (buffer >= m_starts.size()) bad_input("a buffer view refers to a missing buffer");
    const GltfJson& given = member(view, "byteOffset");
    const size_t offset = given.is_null() ? 0 : index_from(given);
    const size_t length = index_from(member(view, "byteLength"));
    const size_t available = m_ends[buffer] - m_starts[buffer];
    if (offset > available || length > available - offset)
      bad_input("a buffer view extends beyond its buffer");
    return {m_starts[buffer] + offset, length};
  }

  void read_images() {
    if (!m_document.json.contains("images")) return;
    for (GltfJson& image : m_document.json["images"]) {
      if (!image.is_object()) bad_input("an image is not an object");
      m_document.images.push_back(bytes_of(image));
      name_after_file(image);
      image.erase("uri");
      image.erase("bufferView");
    }
  }

  SharedBytes bytes_of(const GltfJson& image) const {
    if (const GltfJson& view = member(image, "bufferView"); !view.is_null()) {
      const GltfJson& found = element(m_document.json, "bufferViews", view);
      return std::make_shared<const std::string>(m_document.binary.substr(
          found["byteOffset"].get<size_t>(), found["byteLength"].get<size_t>()));
    }
    if (!member(image, "uri").is_string()) return nullptr;
    try {
      auto bytes = bytes_of_uri(image["uri"].get<std::string>());
      // Passes on images only, whatever an untrusted file's path points to.
      if (image_type(bytes).empty()) return nullptr;
      return std::make_shared<const std::string>(std::move(bytes));
    } catch (const Error&) {
      return nullptr;
    }
  }

  static void name_after_file(GltfJson& image) {
    const GltfJson& uri = member(image, "uri");
    if (image.contains("name") || !uri.is_string()) return;
    const std::string text = uri.get<std::string>();
    if (!is_data_uri(text)) image["name"] = fs::path(decoded_uri(text)).stem().string();
  }

  const std::string m_path;
  const ImportLimits m_limits;
  const ModelFolder m_folder;
  GltfDocument m_document;
  std::vector<size_t> m_starts, m_ends;  // of the file's buffers in the merged buffer
};

}  // namespace

GltfJson parse_gltf_json(const std::string& path, const std::string& text) {
  return json_from_text<GltfJson>(text, say("%1: the glTF JSON is malformed", path),
                                  kGltfJsonLimits);
}

std::string read_gltf_text(const std::string& path) {
  constexpr std::uintmax_t kMaxJson = std::uintmax_t{4} << 30;
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error) &&
      !fs::is_directory(path, error))
    bad_input("%1: is a device or a pipe; accepted: a regular file", path);
  if (is_glb(path)) return read_glb_json(path);
  std::string text = without_mark(path, whole_file(path, kMaxJson));
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos || text[first] != '{')
    bad_input("%1: is not glTF, neither binary nor JSON; accepted: .glb and .gltf", path);
  return text;
}

GltfDocument read_gltf_document(const std::string& path, const ImportLimits& limits) {
  return resolved_gltf(path, parse_gltf_json(path, read_gltf_text(path)), limits);
}

GltfDocument resolved_gltf(const std::string& path, GltfJson json, const ImportLimits& limits) {
  try {
    return DocumentReader(path, limits).read(std::move(json));
  } catch (const GltfJson::exception& e) {
    bad_input("%1: is not valid glTF: %2", path, complaint_of(e));
  } catch (const Error& e) {
    const std::string message = e.what();
    if (message.rfind(path, 0) == 0) bad_input(e.sentence());
    bad_input("%1: is not valid glTF: %2", path, e.sentence());
  }
}

std::string decoded_uri(const std::string& uri) {
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() &&
                        std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    out += escape ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (escape) i += 2;
  }
  return out;
}

const GltfJson& member(const GltfJson& object, const char* key) {
  static const GltfJson none;
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

const GltfJson& element(const GltfJson& root, const char* list, const GltfJson& index) {
  const GltfJson& found = member(root, list);
  const size_t i = index_from(index);
  if (!found.is_array() || i >= found.size())
    bad_input("refers to element %1 of \"%2\", which has %3", i, list,
              found.is_array() ? found.size() : 0);
  if (!found[i].is_object()) bad_input("element %1 of \"%2\" is not an object", i, list);
  return found[i];
}

std::string name_of(const GltfJson& object) {
  const GltfJson& name = member(object, "name");
  return name.is_string() ? name.get<std::string>() : "";
}

size_t index_from(const GltfJson& value) {
  // 2^53: sums of such numbers cannot overflow.
  const bool unsigned_or_positive =
      value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
  if (unsigned_or_positive && value.get<std::uint64_t>() < std::uint64_t{1} << 53)
    return value.get<size_t>();
  bad_input("%1 is not an index or a size",
            value.dump(-1, ' ', false, GltfJson::error_handler_t::replace).substr(0, 40));
}

std::vector<int> scene_roots(const GltfJson& root) {
  const GltfJson& shown = member(root, "scene");
  if (shown.is_null() && member(root, "scenes").empty())
    bad_input("has no scene; accepted: one at least");
  const GltfJson& scene = element(root, "scenes", shown.is_null() ? GltfJson(0u) : shown);
  std::vector<int> roots;
  for (const GltfJson& node : member(scene, "nodes")) {
    element(root, "nodes", node);
    roots.push_back(static_cast<int>(index_from(node)));
  }
  return roots;
}

std::string image_type(const std::string& bytes) {
  if (bytes.rfind("\x89PNG\r\n\x1a\n", 0) == 0) return "image/png";
  if (bytes.rfind("\xff\xd8\xff", 0) == 0) return "image/jpeg";
  if (bytes.size() > 12 && bytes.rfind("RIFF", 0) == 0 && bytes.compare(8, 4, "WEBP") == 0)
    return "image/webp";
  return "";
}

}  // namespace trivet
