// Dialogs for many objects at once.
#pragma once

#include <QWidget>
#include <optional>

#include "apps/edit/document/many.h"

namespace trivet::edit {

// Nullopt: cancelled.

/// @param object  the original, placed.
std::optional<ArrayWish> ask_for_array(QWidget* parent, const Object& object);
/// @param wish  begins with these objects; its count is asked for unless `put_all`.
std::optional<ScatterWish> ask_for_scatter(QWidget* parent, const SceneSnapshot& scene,
                                           ScatterWish wish, bool put_all);
std::optional<AlignWish> ask_for_alignment(QWidget* parent, AlignWish wish);

}  // namespace trivet::edit
