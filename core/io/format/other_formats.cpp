#include "core/io/format/other_formats.h"

#include <algorithm>
#include <array>

#include "core/io/text/words.h"

namespace trivet {
namespace {

struct OtherFormat {
  std::string_view beginning;                  // in lower case
  bool is_behind;                              // declarations and comments may stand before it
  std::array<std::string_view, 3> extensions;  // the usual one first

  bool has(std::string_view extension) const {
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
  }
};

constexpr OtherFormat kFormats[] = {
    {"<collada", true, {".dae", ".xml", ".dae"}},
    {"<x3d", true, {".x3d", ".xml", ".x3d"}},
    {"#vrml v2", false, {".wrl", ".x3dv", ".wrl"}},
    {"kaydara fbx", false, {".fbx", ".fbx", ".fbx"}},
    {"; fbx", false, {".fbx", ".fbx", ".fbx"}},
    {"fbxheaderextension", true, {".fbx", ".fbx", ".fbx"}},
    {"ac3d", false, {".ac", ".acc", ".ac3d"}},
    {"xof 0", false, {".x", ".x", ".x"}},
    {"ms3d000000", false, {".ms3d", ".ms3d", ".ms3d"}},
    {"idp2", false, {".md2", ".md2", ".md2"}},
    {"idp3", false, {".md3", ".md3", ".md3"}},
    {"bb3d", false, {".b3d", ".b3d", ".b3d"}},
    {"blender", false, {".blend", ".blend", ".blend"}},
};
constexpr OtherFormat k3ds{"", false, {".3ds", ".prj", ".3ds"}};
constexpr OtherFormat kLightWave{"", false, {".lwo", ".lxo", ".lwo"}};

// Chunks say how long they are.
bool is_3ds(std::string_view head, std::uintmax_t size) {
  if (head.size() < 6 || !head.starts_with("MM")) return false;
  std::uintmax_t stated = 0;
  for (size_t i = 6; i-- > 2;) stated = stated << 8 | static_cast<unsigned char>(head[i]);
  return stated == size;
}

bool is_lightwave(std::string_view head) {
  const std::string_view kind = head.size() < 12 ? "" : head.substr(8, 4);
  return head.starts_with("FORM") && (kind == "LWO2" || kind == "LWOB" || kind == "LXOB");
}

const OtherFormat* format_of(std::string_view head, std::uintmax_t size) {
  if (is_3ds(head, size)) return &k3ds;
  if (is_lightwave(head)) return &kLightWave;
  while (!head.empty() && (is_blank(head[0]) || is_line_end(head[0]))) head.remove_prefix(1);
  constexpr size_t kLookedAt = 4096;
  const std::string text = lower_case(head.substr(0, kLookedAt));
  for (const OtherFormat& format : kFormats) {
    const size_t at = text.find(format.beginning);
    if (at == 0 || (format.is_behind && at != text.npos)) return &format;
  }
  return nullptr;
}

}  // namespace

bool tells_other_format(std::string_view head, std::uintmax_t size) {
  return format_of(head, size) != nullptr;
}

bool is_told_by_content(const std::string& extension) {
  return k3ds.has(extension) || kLightWave.has(extension) ||
         std::any_of(std::begin(kFormats), std::end(kFormats),
                     [&](const OtherFormat& f) { return f.has(extension); });
}

std::string other_extension(std::string_view head, std::uintmax_t size,
                            const std::string& extension) {
  const OtherFormat* const format = format_of(head, size);
  if (!format || format->has(extension)) return extension;
  return std::string(format->extensions.front());
}

}  // namespace trivet
