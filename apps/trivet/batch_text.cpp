// Progress and totals of a shard, for people or as JSON.
#include <algorithm>
#include <iostream>

#include "apps/farm/batch/stop_signals.h"
#include "apps/trivet/verb_batch_parts.h"
#include "core/base/count_of.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

using namespace trivet::farm;

// Groups without any object in the scenes that were made.
void warn_of_groups(const BatchTotals& totals, const CommonOptions& common) {
  const std::uint64_t made = totals.ok + totals.refused;
  for (const auto& [name, group] : totals.groups) {
    if (group.placed > 0 || made == 0 || totals.there_before > 0) continue;
    if (group.drawn == 0) {
      print_note(common,
                 say("the group \"%1\" has no object: its count was 0 in all scenes", name));
      continue;
    }
    const auto most =
        std::max_element(group.reasons.begin(), group.reasons.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    print_note(common, say("the group \"%1\": none of %2 could be put; most often: %3", name,
                           count_of(group.drawn, "object"), most->first));
  }
}

}  // namespace

void report_to_terminal(BatchOptions& options, const CommonOptions& common) {
  options.log = [&common](const std::string& line) {
    clear_progress_line(common);
    if (!common.quiet) std::cerr << line << "\n";
  };
  if (!shows_progress(common)) return;
  options.on_progress = [](const BatchProgress& progress) {
    constexpr std::uint64_t kWidth = 24;
    const auto full = progress.made * kWidth / std::max<std::uint64_t>(progress.total, 1);
    std::cerr << "\r\033[K[" << std::string(full, '#') << std::string(kWidth - full, '.') << "] "
              << progress_text(progress) << std::flush;
  };
}

int print_totals(const BatchTotals& totals, const BatchOptions& options,
                 const CommonOptions& common) {
  clear_progress_line(common);
  warn_of_groups(totals, common);
  if (totals.work.draws > 0 && !common.quiet)
    std::cerr << "z-lists: " << totals.work.queries << " queries, of " << totals.work.early
              << " asked early, in " << totals.work.draws << " draws and " << totals.work.read_backs
              << " read-backs\n";
  if (common.json)
    std::cout << json_line({{"shard", options.shard.index},
                            {"shards", options.shard.count},
                            {"units", totals.units},
                            {"units_there_before", totals.there_before},
                            {"units_by_others", totals.by_others},
                            {"units_dropped", totals.dropped},
                            {"ok", totals.ok},
                            {"refused", totals.refused},
                            {"failed", totals.failed},
                            {"failed_before", totals.failed_before},
                            {"waiting", totals.waiting},
                            {"queries", totals.work.queries},
                            {"early_queries", totals.work.early},
                            {"draws", totals.work.draws},
                            {"read_backs", totals.work.read_backs},
                            {"notes", totals.notes},
                            {"stopped", totals.stopped}});
  else
    std::cout << "shard " << options.shard.index << " of " << options.shard.count << ": "
              << totals.units << " units, " << totals.there_before
              << " were there; scenes: " << totals.ok << " ok, " << totals.refused << " refused, "
              << totals.failed << " failed"
              << (totals.failed_before > 0
                      ? ", " + std::to_string(totals.failed_before) + " without, as they had failed"
                      : "")
              << (totals.dropped > 0
                      ? "; units made twice and dropped: " + std::to_string(totals.dropped)
                      : "")
              << (totals.waiting > 0
                      ? "; units whose scenes are not there yet: " + std::to_string(totals.waiting)
                      : "")
              << (totals.stopped ? "; stopped: run it again to go on" : "") << "\n";
  return totals.stopped || totals.waiting > 0 ? kComeAgain : totals.failed > 0;
}

}  // namespace trivet::apps
