// A picture of complete z-lists, a pixel per list, with a scale below.
#pragma once

#include "apps/trivet/zlist_text.h"
#include "gpu/image.h"

namespace trivet::apps {

enum class ZListShow {
  Length,   // how many faces
  Depth,    // where the nearest begins
  Objects,  // whose the nearest is
};

/// Pixel (0, 0) is the list (0, 0), on white.
Image zlists_picture(const ZListsOf& what, ZListShow show);

}  // namespace trivet::apps
