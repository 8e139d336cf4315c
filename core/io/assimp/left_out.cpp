#include "core/io/assimp/left_out.h"

#include <algorithm>
#include <set>

#include "core/io/assimp/xml_text.h"
#include "core/io/surface/file_surface.h"

namespace trivet {
namespace {

struct PassedOver {
  std::string_view format, begin;
  int each;  // how often it stands there for one
  const char* what;
};

constexpr PassedOver kPassedOver[] = {
    {"x3d", "<Text", 1, TRIVET_SENTENCE("texts left out")},
    {"x3d", "<ProtoInstance", 1, TRIVET_SENTENCE("instances of prototypes left out")},
    {"x3d", "<LOD", 1, TRIVET_SENTENCE("levels of detail left out")},
    {"x3d", "<GeoLOD", 1, TRIVET_SENTENCE("levels of detail left out")},
    {"x3d", "<HAnimHumanoid", 1, TRIVET_SENTENCE("figures left out")},
    {"x3d", "<NurbsPatchSurface", 1, TRIVET_SENTENCE("NURBS left out")},
    {"x3d", "<NurbsTrimmedSurface", 1, TRIVET_SENTENCE("NURBS left out")},
    {"x3d", "<NurbsSweptSurface", 1, TRIVET_SENTENCE("NURBS left out")},
    {"x3d", "<NurbsSwungSurface", 1, TRIVET_SENTENCE("NURBS left out")},
    {"dae", "<spline", 1, TRIVET_SENTENCE("splines left out")},
    {"dae", "<brep", 1, TRIVET_SENTENCE("curved solids left out")},
    {"dae", "<convex_mesh", 1, TRIVET_SENTENCE("convex hulls left out")},
    // The geometry has the word, and the model that shows it.
    {"fbx", "NurbsSurface", 2, TRIVET_SENTENCE("NURBS left out")},
    {"fbx", "NurbsCurve", 2, TRIVET_SENTENCE("NURBS left out")},
};

std::int64_t num_elements(std::string_view text, std::string_view begin) {
  std::int64_t count = 0;
  for (size_t at = find_element(text, begin, 0); at != text.npos;
       at = find_element(text, begin, at + 1))
    ++count;
  return count;
}

// Instances of Collada whose geometry is not there.
std::int64_t num_broken_references(std::string_view text) {
  std::set<std::string_view> ids;
  for (size_t at = find_element(text, "<geometry", 0); at != text.npos;
       at = find_element(text, "<geometry", at + 1))
    ids.insert(attribute_of(text.substr(at), "id"));
  std::int64_t count = 0;
  for (size_t at = find_element(text, "<instance_geometry", 0); at != text.npos;
       at = find_element(text, "<instance_geometry", at + 1)) {
    const std::string_view url = attribute_of(text.substr(at), "url");
    count += url.starts_with('#') && !ids.contains(url.substr(1));
  }
  return count;
}

}  // namespace

void note_left_out(const std::string& format, std::string_view text, std::vector<Sentence>& notes) {
  for (const PassedOver& kind : kPassedOver)
    if (kind.format == format) {
      const std::int64_t count = num_elements(text, kind.begin);
      note_count(notes, kind.what, (count + kind.each - 1) / kind.each);
    }
  if (format == "dae")
    note_count(notes, "references to geometry that is not there, left out",
               num_broken_references(text));
}

}  // namespace trivet
