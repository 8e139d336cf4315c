#include "apps/farm/batch/source.h"

#include "core/base/bad_input.h"

namespace trivet::farm {

BatchRun scenes_in(const std::string& folder) {
  BatchRun run = read_run(folder);
  if (!run.has_scenes())
    bad_input("%1: there are %2 in this folder; accepted: a batch of scenes", folder,
              run.contents());
  return run;
}

BatchRun source_of(const BatchRun& run, const std::string& folder) {
  BatchRun there = scenes_in(folder);
  if (sha256_hex(run_json(there)) != run.scenes_sha256)
    bad_input("%1: is not the batch that these %2 are of", folder, run.contents());
  return there;
}

bool scenes_are_there(const BatchRun& run, const std::string& folder, const BatchRun& scenes,
                      std::uint64_t unit) {
  const std::uint64_t per_unit = scenes.per_unit;
  for (std::uint64_t t = run.first_scene(unit) / per_unit; t * per_unit < run.end_scene(unit); ++t)
    if (!unit_exists(folder, t, scenes.format)) return false;
  return true;
}

}  // namespace trivet::farm
