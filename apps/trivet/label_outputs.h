// Labelled images of the command line: which files, and writing them.
#pragma once

#include "apps/trivet/label_views.h"

namespace trivet::apps {

struct LabelArguments {
  // Files; empty: not wanted. With several views {} in a name stands for the view's.
  std::string depth, ids, classes, normals, boxes;
  std::string picture;    // of several views
  std::string coco, bop;  // folders
  bool visibility = false;
  double depth_unit = 0.001;  // metres
  ViewArguments views;

  bool any() const {
    return !(depth + ids + classes + normals + boxes + picture + coco + bop).empty();
  }
};
void add_label_options(CLI::App& app, LabelArguments& arguments);

/// Names of its files, of several views with {}.
std::vector<std::string> label_files(const LabelArguments& arguments);

/// Before the work. @throws Error (BadInput) for wrong extensions, names without {} for several
/// views; (Environment) without OpenEXR.
void check_label_outputs(const LabelArguments& arguments);

/// Makes and writes the labelled images of all views.
void write_labels(const std::string& scene_file, const LabelArguments& arguments,
                  const PictureRequest& request, const CommonOptions& common);

}  // namespace trivet::apps
