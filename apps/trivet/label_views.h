// Cameras of labelled images: from the command line, from a file, or on a dome.
#pragma once

#include "apps/trivet/common.h"
#include "apps/trivet/picture.h"
#include "core/picture/scene.h"
#include "ops/files/labels/label_json.h"

namespace trivet::apps {

struct ViewArguments {
  std::string cameras;  // a file; empty: none
  int dome = 0;         // number of cameras; 0: no dome
  std::uint64_t dome_seed = 1;
  double dome_radius = 0;                  // metres; 0: the whole scene is seen
  std::vector<double> dome_elevation_deg;  // lowest and highest; empty: 15 to 75

  bool any() const { return !cameras.empty() || dome > 0; }
};
void add_view_options(CLI::App& app, ViewArguments& arguments);

/// One view from the request's camera (or the automatic one); or those of the file; or of the dome.
/// @throws Error (BadInput) naming the file, the place in it, and what is accepted.
std::vector<LabelView> label_views(const ViewArguments& arguments, const PictureRequest& request,
                                   const PictureScene& scene, const CommonOptions& common);

}  // namespace trivet::apps
