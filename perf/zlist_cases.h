// Queries that are asked of BVHs and z-lists alike, and rows of the latter. Private to
// rows_zlists*.cpp.
#pragma once

#include <string>
#include <vector>

#include "core/candidates/zlist_stage.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"

namespace trivet::perf {

struct Asked {
  Sweep sweep;
  FirstContact truth;
};

/// All queries of one size and motion, and the target of their rows.
struct Cases {
  int num_triangles = 0;
  Motion::Kind kind = Motion::Kind::Translation;
  std::vector<Asked> sweeps;
  double bvh_cpu_ms = 0;
  Report* report = nullptr;
  /// Hash of the BVHs' answers and of all differing answers of others: the number of queries to
  /// others depends on their time.
  ResultHash* hash = nullptr;
};

/// A candidate finder.
struct Method {
  std::string name;    // of a series in the plot
  std::string what;    // of a row
  int resolution = 0;  // 0: automatic
  double goal_ms = 0;
  bool compares = true;       // compared with the CPU time of BVHs
  bool bounds_alone = false;  // computes bounds, no candidates
};

/// Sums of the work left by the stages, for means.
struct Left {
  double pixels = 0, doubtful = 0, pairs = 0, bytes = 0;
  int count = 0, wrong = 0, unusable = 0;

  void add(const CandidatePairs& p, bool right) {
    ++count;
    wrong += !right;
    unusable += !p.usable;
    pixels += static_cast<double>(p.work.pixels);
    doubtful += static_cast<double>(p.work.doubtful_pixels);
    pairs += static_cast<double>(p.work.face_pairs);
    bytes += static_cast<double>(p.work.bytes_read_back);
  }
  std::string text_of(bool bounds_alone) const {
    std::string out = text("means: %.0f pixels, %.0f doubtful", pixels / count, doubtful / count);
    if (!bounds_alone) out += text(", %.0f pairs left", pairs / count);
    if (bytes > 0) out += text(", %.0f bytes read back", bytes / count);
    if (unusable > 0 && !bounds_alone) out += text("; gave up %d of %d", unusable, count);
    if (wrong > 0) return out + text("; WRONG %d", wrong);
    return out + (bounds_alone ? "; the bounds hold" : "; the same bits");
  }
};

/// True if a stage's answer equals that of the BVHs; if not, hashes it.
bool is_right(const FirstContact& found, const FirstContact& truth, ResultHash& hash);

/// Asks all queries, within a budget of time, and adds the row.
void add_stage(const Cases& cases, const Method& method, CandidateFinder& stage);

/// Rows of the GPU's stages.
void zlist_gpu_rows(const Cases& cases);

}  // namespace trivet::perf
