#include "apps/farm/batch/exports.h"

#include <algorithm>

#include "apps/farm/batch/source.h"

namespace trivet::farm {

BatchRun exports_of(const std::string& scenes, const std::vector<std::string>& kinds) {
  BatchRun run = scenes_in(scenes);
  run.scenes_sha256 = sha256_hex(run_json(run));
  run.with_scene = run.with_contacts = run.with_report = false;
  run.format = UnitFormat::Dir;
  for (const std::string& kind : export_kinds())  // in one order
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) run.exports.push_back(kind);
  return run;
}

Work export_work(const BatchRun& run, const std::string& scenes, const std::string& out,
                 const ImportLimits& import) {
  const BatchRun there = source_of(run, scenes);
  Work work = work_of(prepared_recipe(there, scenes), there, import, scenes, true);
  work.exports =
      std::make_shared<const ExportWork>(ExportWork{scenes, there, out, run.exports, run.version});
  return work;
}

}  // namespace trivet::farm
