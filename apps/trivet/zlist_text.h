// Complete z-lists as text, for people and programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/atomic_file.h"
#include "raster/zlist/complete_zlists.h"

namespace trivet::apps {

/// Contents of a picture of z-lists. Pixels are named as in the picture: (column, row from above).
struct ZListsOf {
  std::vector<std::string> names;  // of the bodies
  std::vector<Body> bodies;
  const CompleteZLists* lists = nullptr;
  double milliseconds = 0;  // to compute them

  std::span<const ZListItem> at(int column, int row_from_above) const {
    return lists->list(column, lists->projection().height - 1 - row_from_above);
  }
};

struct ImagePixel {
  int column, row;  // from above
};

/// @param pixel  its list is included; nullopt: none.
std::string zlists_text(const ZListsOf& what, std::optional<ImagePixel> pixel);
std::string zlists_json(const ZListsOf& what, std::optional<ImagePixel> pixel);

/// Writes all lists as JSON lines: a head that describes them, then a line per pixel with a list.
/// Piece by piece, as they may be long.
void write_zlists(const ZListsOf& what, const ByteSink& write);

}  // namespace trivet::apps
