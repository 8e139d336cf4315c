// Batches of pictures: of the scenes of a batch that is there, or being made.
#pragma once

#include "apps/farm/batch/batch.h"

namespace trivet::farm {

/// Run of a batch of pictures, its format and number of scenes per unit apart.
/// @param scenes  folder of the scenes. @param views  their JSON; empty: those of the recipe.
/// @throws Error (BadInput) when the folder is no batch of scenes, or there are no views.
BatchRun pictures_of(const std::string& scenes, const std::string& views);

/// Views of a file with their environments, named as they are stored: in OUT/environments.
struct PreparedViews {
  std::string json;  // empty: those of the recipe
  std::vector<BatchModel> environments;
};
/// @param text, file  see views_text(); its folder is where environments are.
/// @throws Error (BadInput).
PreparedViews prepare_views(const std::string& text, const std::string& file);

/// Its work; models are read from the store of the scenes, once.
/// @param out  folder of the pictures. @param make_opengl  see PictureWork; taken if the run is of
/// pictures by OpenGL.
/// @throws Error (BadInput) when these are not the scenes that the run names, or they do not fit a
///   data set.
Work picture_work(const BatchRun& run, const std::string& scenes, const ImportLimits& import,
                  const std::string& out, const std::function<DrawPicture()>& make_opengl);

/// Files that the scenes of a data set share; they may be there.
/// @return names of models that were found to be surfaces of revolution.
std::vector<std::string> begin_data_set(const std::string& out, const BatchRun& run,
                                        const Work& work);
/// Files that describe all of a data set. @return false: there are scenes to come.
bool end_data_set(const std::string& out, const BatchRun& run, const Work& work);

}  // namespace trivet::farm
