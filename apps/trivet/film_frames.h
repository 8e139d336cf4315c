// Pictures of what the operations of a layout move: numbered files or an animated WebP.
#pragma once

#include <optional>
#include <string>

#include "apps/trivet/common.h"
#include "apps/trivet/picture.h"
#include "ops/files/animation/motion_film.h"
#include "ops/files/layout/watched_run.h"

namespace trivet::apps {

struct FilmFrames {
  std::string file;  // .webp, or .png with {} for the number; empty: none
  double fps = 24;   // pictures in a second
};
void add_film_options(CLI::App& app, FilmFrames& film);

/// @throws Error (BadInput) for a layout of a scene in place, of which there is no film.
void check_can_be_filmed(const Layout& layout);

/// Films a run: `film` is there from the moment when the objects stand. It outlives the run.
RunWatch film_watch(std::optional<MotionFilm>& film);

/// Runs the layout and renders the film of it. From one camera: the one asked for, else one that
/// frames the end.
/// @return the exit status: 1 if an operation was refused or the check failed, which is told.
/// @throws Error (BadInput): `file` is not as above, `layout` is none, or lays out a scene in
/// place.
int render_film(const std::string& layout, const FilmFrames& film, const PictureRequest& request,
                const CommonOptions& common);

}  // namespace trivet::apps
