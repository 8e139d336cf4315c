// Patterns of English sentences of scenes, journals and exports.
#include <QtGlobal>

#include "apps/edit/document/sentence_patterns.h"

namespace trivet::edit {
namespace {

constexpr const char* kFiles[] = {
    QT_TRANSLATE_NOOP("refusal", "cannot be written: %1"),
    QT_TRANSLATE_NOOP("refusal", "cannot be made: %1"),
    QT_TRANSLATE_NOOP("refusal", "cannot be created: %1"),
    QT_TRANSLATE_NOOP("refusal", "this folder cannot be made"),
    QT_TRANSLATE_NOOP("refusal", "a temporary file cannot be written: %1"),
    QT_TRANSLATE_NOOP("refusal", "the extras of %1 are not valid JSON: %2"),
    QT_TRANSLATE_NOOP("refusal", "is not glTF: its JSON has no asset"),
    QT_TRANSLATE_NOOP("refusal", "a scene, which trivet run makes of a layout"),
    QT_TRANSLATE_NOOP("refusal",
                      "object '%1' lies beyond the range of float32, or its pose "
                      "is not finite"),
    QT_TRANSLATE_NOOP("refusal", "it cannot be exported"),
    QT_TRANSLATE_NOOP("refusal", "the scene has %1 triangles, more than %2 supports"),
    QT_TRANSLATE_NOOP("refusal", "a mesh without triangles"),
    QT_TRANSLATE_NOOP("refusal", "one at least"),
    QT_TRANSLATE_NOOP("refusal", "%1: is an input, named by %2, and would be overwritten"),
    QT_TRANSLATE_NOOP("refusal", "is an input and would be overwritten"),
    QT_TRANSLATE_NOOP("refusal", "another name"),
    QT_TRANSLATE_NOOP("refusal", "exists and does not belong to %1, so it would be overwritten"),
    QT_TRANSLATE_NOOP("refusal", "another name or folder, or a single-file format, such as .glb"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" is no format of one file"),
    QT_TRANSLATE_NOOP("refusal", "%1; accepted are %2"),
    QT_TRANSLATE_NOOP("refusal", "cannot write %1"),
    QT_TRANSLATE_NOOP("refusal", "no extension"),
    QT_TRANSLATE_NOOP("refusal", ".glb, .ply and .stl"),
    QT_TRANSLATE_NOOP("refusal", ".glb, .gltf, .obj, .ply and .stl"),
    QT_TRANSLATE_NOOP("refusal", "has no extension of a format"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" was changed"),
    QT_TRANSLATE_NOOP("refusal", "the geometry of \"%1\" was changed since Trivet wrote it"),
    QT_TRANSLATE_NOOP("refusal", "the scene was moved since Trivet wrote it"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" was moved since Trivet wrote it"),
    QT_TRANSLATE_NOOP("refusal", "scenes as Trivet wrote them"),
    QT_TRANSLATE_NOOP("refusal", "scenes that Trivet wrote"),
    QT_TRANSLATE_NOOP("refusal", "has no data of Trivet"),
    QT_TRANSLATE_NOOP("refusal", "is not the mesh that Trivet wrote"),
    QT_TRANSLATE_NOOP("refusal", "has %1 triangles, not %2 as Trivet wrote"),
    QT_TRANSLATE_NOOP("refusal", "another program has changed it"),
    QT_TRANSLATE_NOOP("refusal", "has no mesh for \"%1\""),
    QT_TRANSLATE_NOOP("refusal", "is no array in base64 of items of %1 bytes"),
    QT_TRANSLATE_NOOP("refusal", "is not the material of each triangle"),
    QT_TRANSLATE_NOOP("refusal", "has not 9 numbers per triangle"),
    QT_TRANSLATE_NOOP("refusal",
                      "the geometry of \"%1\" is that of the scene file, rounded "
                      "to float32: the model file is missing or has changed"),
    QT_TRANSLATE_NOOP("refusal",
                      "\"%1\", which was out of the scene, is left out: \"%2\" is "
                      "missing or has changed"),
    QT_TRANSLATE_NOOP("refusal", "%1 \"%2\": refused: %3"),
    QT_TRANSLATE_NOOP("refusal",
                      "the last line of \"%1\" is torn: its operation was never "
                      "committed, and is left out"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" does not give the same scene to the bit"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" is restored up to here: %2"),
    QT_TRANSLATE_NOOP("refusal", "line %1"),
    QT_TRANSLATE_NOOP("refusal", "the result is not the same to the bit"),
    QT_TRANSLATE_NOOP("refusal", "there is nothing to undo or redo"),
    QT_TRANSLATE_NOOP("refusal",
                      "neither \"%1\" nor \"%2\" is the file that the session "
                      "began with"),
    QT_TRANSLATE_NOOP("refusal", "the same bytes"),
    QT_TRANSLATE_NOOP("refusal", "line %1 is damaged, and others follow it"),
    QT_TRANSLATE_NOOP("refusal", "a journal as Trivet wrote it"),
    QT_TRANSLATE_NOOP("refusal", "a journal that Trivet wrote"),
    QT_TRANSLATE_NOOP("refusal", "is no journal"),
    QT_TRANSLATE_NOOP("refusal", "the journal cannot be opened: %1"),
    QT_TRANSLATE_NOOP("refusal", "the journal cannot be locked: %1"),
    QT_TRANSLATE_NOOP("refusal", "the journal cannot be read: %1"),
    QT_TRANSLATE_NOOP("refusal", "the journal cannot be written: %1"),
    QT_TRANSLATE_NOOP("refusal", "another session is writing this journal"),
    QT_TRANSLATE_NOOP("refusal", "another session has written this journal"),
    QT_TRANSLATE_NOOP("refusal", "there is a journal already"),
    QT_TRANSLATE_NOOP("refusal", "a new name, or restore this one"),
    QT_TRANSLATE_NOOP("refusal", "there is no folder \"%1\" for the journal"),
    QT_TRANSLATE_NOOP("refusal", "16 hexadecimal digits"),
    QT_TRANSLATE_NOOP("refusal", "%1, the version of the journal"),
    QT_TRANSLATE_NOOP("refusal", "an operation or several"),
    QT_TRANSLATE_NOOP("refusal", "cannot be opened"),
    QT_TRANSLATE_NOOP("refusal", "%1; BVHs are used instead"),
    QT_TRANSLATE_NOOP("refusal", "a scene (.glb) written by Trivet, or a layout (.json)"),
    QT_TRANSLATE_NOOP("refusal", "cannot be saved"),
    QT_TRANSLATE_NOOP("refusal", "a file name ending in .glb or .json"),
    QT_TRANSLATE_NOOP("refusal", "is open in another editor; close it there first"),
    QT_TRANSLATE_NOOP("refusal",
                      "demos need a recovery folder for their files, and this "
                      "editor has none"),
    QT_TRANSLATE_NOOP("refusal",
                      "wishes: accepted: a section \"arrange\", as trivet schema "
                      "arrange has it"),
    QT_TRANSLATE_NOOP("refusal", "no demo '%1'"),
    QT_TRANSLATE_NOOP("refusal", "no arranged demo '%1'"),
    QT_TRANSLATE_NOOP("refusal", "there are %1"),
    QT_TRANSLATE_NOOP("refusal", "MuJoCo does not accept it: %1"),
    QT_TRANSLATE_NOOP("refusal", "\"%1\" has no size and so no mass"),
    QT_TRANSLATE_NOOP("refusal", "it cannot be simulated"),
    QT_TRANSLATE_NOOP("refusal",
                      "convex parts of \"%1\" and \"%2\" overlap by %3 metres, "
                      "more than %4: a simulator would push them apart"),
    QT_TRANSLATE_NOOP("refusal",
                      "convex parts of \"%1\" and \"%2\" overlap by %3 metres, "
                      "more than %4, and of %5 more pairs: a simulator would push "
                      "them apart"),
    QT_TRANSLATE_NOOP("refusal", "--max-overlap from %1"),
    QT_TRANSLATE_NOOP("refusal", "the picture of %1 x %2 pixels cannot be encoded as PNG: %3"),
    QT_TRANSLATE_NOOP("refusal", "a picture of %1 x %2 pixels"),
    QT_TRANSLATE_NOOP("refusal", "a picture of %1 samples"),
    QT_TRANSLATE_NOOP("refusal", "%1 to %2 in each dimension"),
};

}  // namespace

std::span<const char* const> file_patterns() { return kFiles; }

}  // namespace trivet::edit
