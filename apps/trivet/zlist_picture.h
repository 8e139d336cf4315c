// A picture of complete z-lists, a pixel per list, with a scale below.
#pragma once

#include "apps/trivet/zlist_text.h"
#include "core/base/image.h"

namespace trivet::apps {

enum class ZListShow {
  Length,   // number of faces
  Depth,    // nearest depth
  Objects,  // object of the nearest face
};

/// Pixel (0, 0) shows the list (0, 0), on white.
Image zlists_picture(const ZListsOf& what, ZListShow show);

}  // namespace trivet::apps
