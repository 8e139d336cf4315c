// Patterns of English sentences about glTF: what is wrong, and what is left out.
#include <QtGlobal>

#include "apps/edit/document/sentence_patterns.h"

namespace trivet::edit {
namespace {

constexpr const char* kGltf[] = {
    QT_TRANSLATE_NOOP("refusal", "has no scene"),
    QT_TRANSLATE_NOOP("refusal", "its Draco data has no attribute %1"),
    QT_TRANSLATE_NOOP("refusal", "its Draco data is damaged: %1"),
    QT_TRANSLATE_NOOP("refusal", "a point without a value"),
    QT_TRANSLATE_NOOP("refusal", "a face without a point"),
    QT_TRANSLATE_NOOP("refusal", "it is compressed by Draco, which this build lacks"),
    QT_TRANSLATE_NOOP("refusal", "files without KHR_draco_mesh_compression"),
    QT_TRANSLATE_NOOP("refusal", "an entry of \"extensionsRequired\" is no text"),
    QT_TRANSLATE_NOOP("refusal", "requires %1, which Trivet does not have"),
    QT_TRANSLATE_NOOP("refusal", "files that do without"),
    QT_TRANSLATE_NOOP("refusal", "positions and normals that are no vectors of 3"),
    QT_TRANSLATE_NOOP("refusal", "vertices left out, too few for another triangle: %1"),
    QT_TRANSLATE_NOOP("refusal", "primitives left out, as they have no positions: %1"),
    QT_TRANSLATE_NOOP("refusal", "normals left out, as they are not one to each vertex: %1"),
    QT_TRANSLATE_NOOP("refusal", "meshes with morph targets, read without them: %1"),
    QT_TRANSLATE_NOOP("refusal",
                      "its nodes do not form a tree: two have node %1 among their children"),
    QT_TRANSLATE_NOOP("refusal", "a compressed buffer view %1"),
    QT_TRANSLATE_NOOP("refusal", "of mode %1 and filter %2 has %3 items of %4 bytes"),
    QT_TRANSLATE_NOOP("refusal", "has the mode %1"),
    QT_TRANSLATE_NOOP("refusal", "of %1 bytes claims to hold %2 items of %3"),
    QT_TRANSLATE_NOOP("refusal", "has the filter %1"),
    QT_TRANSLATE_NOOP("refusal", "NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL and COLOR"),
    QT_TRANSLATE_NOOP("refusal", "is damaged"),
    QT_TRANSLATE_NOOP("refusal",
                      "a buffer view is compressed by meshoptimizer, which this build lacks"),
    QT_TRANSLATE_NOOP("refusal", "files without EXT_meshopt_compression"),
    QT_TRANSLATE_NOOP("refusal", "other scenes left out: %1 (%2)"),
    QT_TRANSLATE_NOOP("refusal", "has more than %1 instances, the limit"),
    QT_TRANSLATE_NOOP("refusal", "instances have a %1 of %2 components"),
    QT_TRANSLATE_NOOP("refusal", "instances have %1 values of %2 for %3 instances"),
    QT_TRANSLATE_NOOP("refusal", "instance %1 has a %2 that is not finite"),
    QT_TRANSLATE_NOOP("refusal", "a buffer view that is compressed"),
    QT_TRANSLATE_NOOP("refusal", "instances by extension"),
    QT_TRANSLATE_NOOP("refusal", "a mesh that is compressed by Draco"),
    QT_TRANSLATE_NOOP("refusal", "has the type %1"),
    QT_TRANSLATE_NOOP("refusal", "an accessor has %1 items and no data"),
    QT_TRANSLATE_NOOP("refusal", "indices have the component type %1"),
    QT_TRANSLATE_NOOP("refusal", "5121, 5123 and 5125"),
    QT_TRANSLATE_NOOP("refusal", "a sparse accessor of %1 items replaces item %2"),
    QT_TRANSLATE_NOOP("refusal", "a primitive has the mode %1"),
    QT_TRANSLATE_NOOP("refusal", "0 to 6"),
    QT_TRANSLATE_NOOP("refusal", "index %1 refers to vertex %2 of %3"),
    QT_TRANSLATE_NOOP("refusal", "names \"%1\", which is missing"),
    QT_TRANSLATE_NOOP("refusal", "is UTF-16 text"),
    QT_TRANSLATE_NOOP("refusal", "glTF in UTF-8"),
    QT_TRANSLATE_NOOP("refusal", "mesh '%1', primitive %2: %3"),
};

}  // namespace

std::span<const char* const> gltf_patterns() { return kGltf; }

}  // namespace trivet::edit
