// The example recipe of scenes like BREAKFAST, for programs that are run without its file.
#pragma once

namespace trivet::perf {

extern const char* const kBreakfastRecipe;

}  // namespace trivet::perf
