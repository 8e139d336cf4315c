// Sections of the table. Each measures, and adds its rows and the hash of its results.
#pragma once

#include "perf/report.h"

namespace trivet::perf {

void first_contact_rows(Report& report);  // ours and FCL's, on the same motions
void put_rows(Report& report);            // the demos, also refined
void scale_rows(Report& report);          // operations among 100 to 100,000 objects
void real_scale_rows(Report& report);     // the same among real models, if there are any
void push_rows(Report& report);           // one step of a PUSH, and a table with its loads
void table1_rows(Report& report);         // the paper's Table 1, by candidate finder
void zlist_rows(Report& report);          // z-lists and BVHs, same motions
void place_rows(Report& report);          // thousands of places at once
void confirm_rows(Report& report);        // stages of a query by each finder
void together_rows(Report& report);       // queries that share a draw of a GPU
void draw_rows(Report& report);           // draws and read-backs of operations and batches
void settling_rows(Report& report);       // ours, Bullet's and MuJoCo's, from the same starts
void shape_rows(Report& report);          // memory, index, import

/// Longer measurements use their first run.
inline constexpr double kLong_ms = 50;

/// Shorter ones follow an uncounted run: caches are warm, as between the queries of a PUT.
template <class Work>
Took timed_warm(Work&& work, clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  const Took first = timed(work, clock);
  return first.wall_ms > kLong_ms ? first : timed(work, clock);
}

}  // namespace trivet::perf
