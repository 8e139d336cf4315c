// Batches of pictures: of the scenes of a batch that is there, or being made.
#pragma once

#include "apps/farm/batch/batch.h"

namespace trivet::farm {

/// Run of a batch of pictures, its format and number of scenes per unit apart.
/// @param scenes  folder of the scenes. @param views  their JSON; empty: those of the recipe.
/// @throws Error (BadInput) when the folder is no batch of scenes, or there are no views.
BatchRun pictures_of(const std::string& scenes, const std::string& views);

/// Its work; models are read from the store of the scenes, once.
/// @param make_opengl  see PictureWork; taken if the run is of pictures by OpenGL.
/// @throws Error (BadInput) when these are not the scenes that the run names.
Work picture_work(const BatchRun& run, const std::string& scenes, const ImportLimits& import,
                  const MakePictures& make_opengl);

/// True if all scenes of a unit of `run` are there.
bool scenes_are_there(const BatchRun& run, const PictureWork& work, std::uint64_t unit);

}  // namespace trivet::farm
