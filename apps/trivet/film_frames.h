// Pictures of what the operations of a layout move: numbered files or an animated WebP.
#pragma once

#include <string>

#include "apps/trivet/common.h"
#include "apps/trivet/picture.h"

namespace trivet::apps {

struct FilmFrames {
  std::string file;  // .webp, or .png with {} for the number; empty: none
  double fps = 24;   // pictures in a second
};
void add_film_options(CLI::App& app, FilmFrames& film);

/// Runs the layout and renders the film of it. From one camera: the one asked for, else one that
/// frames the end.
/// @throws Error (BadInput): `file` is not as above, `layout` is none, or lays out a scene in
/// place.
void render_film(const std::string& layout, const FilmFrames& film, const PictureRequest& request,
                 const CommonOptions& common);

}  // namespace trivet::apps
