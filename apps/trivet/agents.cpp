#include "apps/trivet/agents.h"

#include "apps/trivet/outputs.h"
#include "apps/trivet/picture.h"

namespace trivet::apps {
namespace {

constexpr double kUsualSeconds = 60;  // of an operation
constexpr int kAgentSamples = 4;      // a draft: agents look often

mcp::DrawPng draft_pictures(const CommonOptions& common) {
  return [&common](const Scene& scene, const std::optional<Camera>& camera, int width, int height) {
    PictureRequest request;
    request.width = width, request.height = height;
    request.samples = kAgentSamples;
    request.renderer = "path";
    request.num_threads = common.num_threads;
    return PictureMaker(request).png(scene, camera);
  };
}

}  // namespace

mcp::WorkplaceOptions agent_options(const ForeignArguments& foreign, const SettleArguments& settle,
                                    const CommonOptions& common) {
  mcp::WorkplaceOptions out;
  out.run = run_options(common, settle);
  out.run.progress = {};
  if (!(out.run.context.time_budget_s > 0)) out.run.context.time_budget_s = kUsualSeconds;
  out.others = open_options(foreign, common);
  out.version = TRIVET_VERSION;
  out.draw = draft_pictures(common);
  return out;
}

}  // namespace trivet::apps
