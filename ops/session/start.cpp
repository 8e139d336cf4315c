#include "ops/session/start.h"

#include <filesystem>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/recorded_step.h"

namespace trivet {
namespace {

OpenedSession open_scene(const std::string& content, const std::string& file,
                         const ModelSource& models, const RunOptions& options,
                         const ImportLimits& limits) {
  const std::string folder = folder_of(file);
  SceneFile scene = read_scene_file(content, limits, folder.empty() ? "." : folder);
  const SettleOptions settle = settle_options(options, scene.layout.settle);
  update_contacts(scene.scene, scene.clearance, settle);
  const SettleRules rules = rules_of(settle);
  scene.layout.settle = rules;
  return {Session(std::move(scene.scene), std::move(scene.layout), models),
          file,
          folder,
          scene.clearance,
          std::move(scene.notes),
          rules};
}

Layout read_start(const std::string& content, const RunOptions& options,
                  const ImportLimits& limits) {
  Layout layout = read_layout(content, limits.max_file_bytes);
  layout.settle = rules_of(settle_options(options, layout.settle));
  return layout;
}

OpenedSession session_of(Scene scene, Layout layout, const std::string& file,
                         const ModelSource& models, const RunOptions& options,
                         std::vector<Sentence> notes) {
  const SettleRules rules = layout.settle;
  return {Session(std::move(scene), std::move(layout), models),
          file,
          folder_of(file),
          options.settle.clearance,
          std::move(notes),
          rules};
}

}  // namespace

bool is_layout(const std::string& file) {
  return std::filesystem::path(file).extension() == ".json";
}

OpenedSession open_start(const std::string& content, const std::string& file,
                         const ModelSource& models, const RunOptions& options,
                         const ImportLimits& limits) {
  if (!is_layout(file)) return open_scene(content, file, models, options, limits);
  Layout layout = read_start(content, options, limits);
  LayoutRun run = run_layout(layout, models, options);
  std::vector<Sentence> notes;
  for (const OperationRecord& record : run.operations)
    if (!record.result.ok())
      notes.push_back(say("%1 \"%2\": refused: %3", record.op, record.object,
                          sentence_of(*record.result.refusal)));
  return session_of(std::move(run.scene), std::move(layout), file, models, options,
                    std::move(notes));
}

OpenedSession open_recorded_layout(const std::string& content, const std::string& file,
                                   const ModelSource& models, const RecordedPoses& poses,
                                   const RunOptions& options, const ImportLimits& limits) {
  Layout layout = read_start(content, options, limits);
  Scene scene = make_scene(layout, models, options);
  std::vector<Operation> operations = layout.operations;
  for (Operation& operation : operations)
    if (auto* const append = std::get_if<AppendOperation>(&operation)) {
      load_model(scene, models, *append);
      if (!append->material) append->material = layout.material;
    }
  Transaction transaction(scene);
  repeat_recorded(transaction, operations, poses, with_rules(options.settle, layout.settle));
  transaction.commit();
  return session_of(std::move(scene), std::move(layout), file, models, options, {});
}

}  // namespace trivet
