#include "apps/farm/batch/audit.h"
#include "apps/farm/batch/exports.h"
#include "apps/farm/batch/pictures.h"
#include "core/base/bad_input.h"

namespace trivet::farm {
namespace {

/// Bytes that a scene has to have when it is made again.
struct Sampled {
  std::string json;
  std::map<std::string, Digest> more;
};
using Sample = std::map<std::uint64_t, Sampled>;

// The same scenes each time, in every part of the batch.
bool is_sampled(std::uint64_t k, double share) {
  return Decision({0, 0}, k, "verify").unit() < share;
}

Sampled sampled(const Json& scene, const std::vector<Member>& members) {
  Sampled out{json_line(scene), {}};
  for (size_t i = 1; i < members.size(); ++i) out.more[members[i].name] = sha256(members[i].bytes);
  return out;
}

void check_bytes(const std::string& out, const BatchRun& run, double share, Sample& sample,
                 Verification& result) {
  const std::string batch = run.id();
  for (std::uint64_t unit = 0; unit < run.num_units(); ++unit) {
    if (!unit_exists(out, unit, run.format)) continue;
    ++result.units;
    std::uint64_t expected = run.first_scene(unit);
    const std::string finding = check_unit(
        out, unit, run.format, batch, [&](const Json& scene, const std::vector<Member>& members) {
          ++result.scenes;
          if (scene.at("k") != expected++)
            result.findings.push_back("unit " + std::to_string(unit) + " lacks a scene");
          if (scene.at("status") == "failed" || share <= 0) return;  // failures have other causes
          const std::uint64_t k = expected - 1;
          if (sample.empty() || is_sampled(k, share)) sample[k] = sampled(scene, members);
        });
    if (!finding.empty())
      result.findings.push_back(finding);
    else if (expected != run.end_scene(unit))
      result.findings.push_back("unit " + std::to_string(unit) + " lacks scenes");
  }
}

std::string difference(const Sampled& there, const SceneMembers& made) {
  if (json_line(made.scene) != there.json) return "other poses";
  if (made.more.size() != there.more.size()) return "other members";
  for (const Member& member : made.more) {
    const auto it = there.more.find(member.name);
    if (it == there.more.end() || it->second != sha256(member.bytes))
      return "another " + member.name;
  }
  return "";
}

Work work_again(const BatchRun& run, const std::string& out, const VerifyOptions& options) {
  if (!run.has_scenes() && options.scenes.empty())
    bad_input("%1: is a batch of %2; accepted: with --scenes, the folder of its scenes", out,
              run.contents());
  if (!run.exports.empty()) return export_work(run, options.scenes, out, options.import);
  if (!run.views.empty()) {
    if (run.with_opengl && options.before_opengl) options.before_opengl();
    return picture_work(run, options.scenes, options.import, out, options.make_opengl);
  }
  return work_of(prepared_recipe(run, out), run, options.import, out, true);
}

/// @param folder  that has their store.
void check_models(const std::string& folder, const Work& work, Verification& result) {
  for (const auto& [stored, unused] : work.file_of)
    if (const std::string finding = check_stored(folder, stored); !finding.empty())
      result.findings.push_back(finding);
}

}  // namespace

Verification verify_batch(const std::string& out, const VerifyOptions& options) {
  Verification result;
  BatchRun run;
  try {
    run = read_run(out);
  } catch (const Error& e) {
    if (!has_run(out)) throw;
    result.findings.emplace_back(e.what());  // what it says of units is not to be trusted
    return result;
  }
  Sample sample;
  const Work work = work_again(run, out, options);
  check_bytes(out, run, options.sample, sample, result);
  check_models(run.has_scenes() ? out : options.scenes, work, result);
  if (sample.empty() || !result.findings.empty()) return result;
  if (run.version != options.version) {
    result.other_version = run.version;  // whose poses may differ in their last digits
    return result;
  }
  std::vector<std::uint64_t> ks;
  ks.reserve(sample.size());
  for (const auto& [k, unused] : sample) ks.push_back(k);
  result.stopped =
      !make_only(work, ks, options.jobs, options.limits, [&](const SceneMembers& made) {
        ++result.made_again;
        const std::uint64_t k = made.scene.at("k");
        const std::string what = difference(sample.at(k), made);
        if (!what.empty())
          result.findings.push_back("scene " + std::to_string(k) + " made again has " + what);
      });
  return result;
}

}  // namespace trivet::farm
