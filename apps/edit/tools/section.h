// Sections: views that cut away what stands in front of the active object.
#pragma once

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/view.h"

namespace trivet::edit {

/// State of one view's section plane, which is across the view.
struct Section {
  bool on = false;
  bool only_if_hidden = false;  // as long as it is not moved: cuts only what hides the object
  double shift = 0;             // metres away from the viewer

  friend bool operator==(const Section&, const Section&) = default;
};

/// Depth at which a view is cut: just in front of the active object and its loads, shifted; without
/// an active object that is placed, in the middle of the scene. Nullopt: it is off, or hides
/// nothing.
/// @param except  objects that are not drawn.
std::optional<double> section_depth(const SceneSnapshot& scene, const Selection& selection,
                                    const View& view, const Section& section,
                                    const std::vector<ObjectId>& except);

}  // namespace trivet::edit
