// A judged scene as a page for browsers, with its findings marked; it needs nothing but itself.
#pragma once

#include <string>

#include "ops/files/foreign/findings.h"

namespace trivet::apps {

inline constexpr size_t kMostFacesOfPage = 2'000'000;

/// The page of Python's viewer (apps/python/trivet/viewer.html) with a list of findings.
/// @param scene  that was judged. @param lift  from the verdict's points to the scene's, metres.
/// @throws Error (BadInput): more faces than kMostFacesOfPage.
std::string scene_page(const Scene& scene, const SceneVerdict& verdict, double lift);

}  // namespace trivet::apps
