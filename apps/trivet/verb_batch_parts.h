// Options shared by the verbs of batches. Private to verb_batch*.cpp.
#pragma once

#include "apps/farm/batch/batch.h"
#include "apps/trivet/verbs.h"

namespace trivet::apps {

/// --jobs, --scene-seconds, --scene-memory-mb, --retries, --recycle.
void add_worker_options(CLI::App& verb, int& jobs, farm::WorkLimits& limits);

/// The number asked for, else --threads, else the cores that this process may use.
int num_jobs(int asked, const CommonOptions& common);

/// Lines for people; on a terminal a bar with rate and remaining time.
void report_to_terminal(farm::BatchOptions& options, const CommonOptions& common);

/// Prints the totals of a shard, for people or as JSON. @return the exit status.
int print_totals(const farm::BatchTotals& totals, const farm::BatchOptions& options,
                 const CommonOptions& common);

/// Pictures by OpenGL in the process that calls it.
farm::DrawPicture opengl_pictures();
/// Tries OpenGL in a process of its own, as what it opens must not be inherited by others.
/// @return the device.   @throws Error (Environment)
std::string tried_opengl();

Verb add_batch_pictures(CLI::App& batch, const CommonOptions& common);
Verb add_batch_export(CLI::App& batch, const CommonOptions& common);

/// status, verify, merge and materialise.
std::vector<Verb> add_batch_audits(CLI::App& batch, const CommonOptions& common);

}  // namespace trivet::apps
