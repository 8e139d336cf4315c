// Patterns of refusals (ops/base/refusal_text.cpp), which arrangements tell as text.
#include <QtGlobal>

#include "apps/edit/document/sentence_patterns.h"

namespace trivet::edit {
namespace {

constexpr const char* kRefusals[] = {
    QT_TRANSLATE_NOOP("refusal", "the floor"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 is no name; accepted: UTF-8 without control characters, "
                      "not \"floor\""),
    QT_TRANSLATE_NOOP("refusal", "there is an object %1 already"),
    QT_TRANSLATE_NOOP("refusal", "the model %1 of %2 was not loaded"),
    QT_TRANSLATE_NOOP("refusal", "%1 cannot follow a hand"),
    QT_TRANSLATE_NOOP("refusal", "there is no object %1"),
    QT_TRANSLATE_NOOP("refusal", "there is no object %1 to put %2 on"),
    QT_TRANSLATE_NOOP("refusal", "%1; did you mean %2?"),
    QT_TRANSLATE_NOOP("refusal", "%1 is fixed and would have to move along: unfix it first"),
    QT_TRANSLATE_NOOP("refusal", "%1 is fixed: unfix it first"),
    QT_TRANSLATE_NOOP("refusal", "%1 is locked and would have to move along: unlock it first"),
    QT_TRANSLATE_NOOP("refusal", "%1 is locked: unlock it first"),
    QT_TRANSLATE_NOOP("refusal", "%1 is not in the scene: put it there first"),
    QT_TRANSLATE_NOOP("refusal", "%1 is not in the scene"),
    QT_TRANSLATE_NOOP("refusal", "there is no floor to put %1 on"),
    QT_TRANSLATE_NOOP("refusal", "%1 cannot be put on itself or on what it carries"),
    QT_TRANSLATE_NOOP("refusal",
                      "a clearance of %1 m is not between %2 and %3 m for a scene "
                      "of this size"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 reaches a coordinate of %2 m: the clearance there, %3 m, "
                      "is too coarse for %4 of %5 m; accepted: coordinates and "
                      "sizes of scenes up to %6 m"),
    QT_TRANSLATE_NOOP("refusal", "%1, or a clearance that is asked for, up to %2 m"),
    QT_TRANSLATE_NOOP("refusal", "%1 passes through %2"),
    QT_TRANSLATE_NOOP("refusal", "%1 is inside %2"),
    QT_TRANSLATE_NOOP("refusal", "%1 would touch %2 in the float32 values of an exported file"),
    QT_TRANSLATE_NOOP("refusal", "%1 reaches below the floor"),
    QT_TRANSLATE_NOOP("refusal", "%1 would reach below the floor in an exported file"),
    QT_TRANSLATE_NOOP("refusal", "at its start position %1"),
    QT_TRANSLATE_NOOP("refusal", "at its position %1"),
    QT_TRANSLATE_NOOP("refusal", "%1: move it out freely first"),
    QT_TRANSLATE_NOOP("refusal", "%1 touches %2 already"),
    QT_TRANSLATE_NOOP("refusal", "nothing is below %1: it would fall for ever"),
    QT_TRANSLATE_NOOP("refusal", "the scene would not stand at friction %1: %2 would move"),
    QT_TRANSLATE_NOOP("refusal", "%1 touches something at its start"),
    QT_TRANSLATE_NOOP("refusal", "%1 did not come to rest within %2 motions"),
    QT_TRANSLATE_NOOP("refusal", "%1 did not get to the end of its way within %2 motions"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 is wedged in the air: it can neither sink further nor be "
                      "held there"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 is wedged against %2: it can neither sink further nor be "
                      "held there"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 is wedged between %2: it can neither sink further nor be "
                      "held there"),
    QT_TRANSLATE_NOOP("refusal", "%1 lies on nothing along which it could be pushed"),
    QT_TRANSLATE_NOOP("refusal", "%1 lies on nothing: there is no contact %2"),
    QT_TRANSLATE_NOOP("refusal", "%1 does not touch %2: there is no contact %3"),
    QT_TRANSLATE_NOOP("refusal", "anything"),
    QT_TRANSLATE_NOOP("refusal", "%1 touches %2 in one point: there is no line to turn about"),
    QT_TRANSLATE_NOOP("refusal", "to turn about"),
    QT_TRANSLATE_NOOP("refusal", "to pick it up from"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 cannot be kept %2 m away from everything else: a scene "
                      "so large is too coarse for its objects, the smallest of "
                      "which is %3 m; accepted: a distance to keep of up to %4 m"),
    QT_TRANSLATE_NOOP("refusal", "%1 would come to rest against %2"),
    QT_TRANSLATE_NOOP("refusal", "%1 would come to rest too near to %2"),
    QT_TRANSLATE_NOOP("refusal", "%1 fits nowhere on %2 in its region"),
    QT_TRANSLATE_NOOP("refusal", "%1 would come to rest partly outside its region"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 would not stand well: it tips over an edge %2 m away; "
                      "accepted: %3 m or more"),
    QT_TRANSLATE_NOOP("refusal",
                      "%1 would not stand well: it needs friction of %2; accepted: "
                      "%3 or less"),
    QT_TRANSLATE_NOOP("refusal",
                      "no free place for %1 on %2: of %3 places, every %4 m, %5 "
                      "are over no part of it and %6 are blocked by other things"),
    QT_TRANSLATE_NOOP("refusal", "%1; at %2 more it would leave its region"),
    QT_TRANSLATE_NOOP("refusal", "%1; it was tried at %2 others: first %3"),
    QT_TRANSLATE_NOOP("refusal", "not tried, because %1 of %2 was refused before"),
    QT_TRANSLATE_NOOP("refusal", "%1 of %2 was cancelled"),
    QT_TRANSLATE_NOOP("refusal", "%1 of %2 did not end within %3 s"),
};

}  // namespace

std::span<const char* const> refusal_patterns() { return kRefusals; }

}  // namespace trivet::edit
