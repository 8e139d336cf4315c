#include "apps/farm/batch/templates.h"

#include <algorithm>
#include <filesystem>

#include "apps/farm/scene/scene_json.h"

namespace trivet::farm {
namespace {

// Tasks of some minutes to hours, at a scene a second; Slurm's arrays have 1,000 tasks at most
// unless configured otherwise.
std::uint64_t shards_for(std::uint64_t count, std::uint64_t per_unit) {
  constexpr std::uint64_t kScenesOfTask = 1000;
  const std::uint64_t units = (count + per_unit - 1) / per_unit;
  return std::min(units, std::clamp<std::uint64_t>(count / kScenesOfTask, 1, 200));
}

const char* const kSlurm = R"(#!/bin/bash
# sbatch this: @SHARDS@ tasks of about @EACH@ scenes each. For another number of tasks set TRIVET_SHARDS
# when you print this file. Exit 75 means: come again; slurm.conf may have RequeueExit=75.
#SBATCH --array=0-@LAST@%50 --requeue --open-mode=append --time=2:00:00
#SBATCH --mem=2G --cpus-per-task=@JOBS@ --signal=B:TERM@60
export TRIVET_SHARDS=@SHARDS@
exec trivet @WORDS@
)";

const char* const kKubernetes = R"(apiVersion: batch/v1   # 1.33 and later: backoffLimitPerIndex
kind: Job
metadata: {name: scenes}
spec:
  completionMode: Indexed
  completions: @SHARDS@
  parallelism: 50
  backoffLimitPerIndex: 5
  podFailurePolicy:
    rules:
      - {action: Ignore, onPodConditions: [{type: DisruptionTarget}]}
      - {action: FailIndex, onExitCodes: {containerName: trivet, operator: In, values: [1, 2]}}
  template:
    spec:
      restartPolicy: Never
      terminationGracePeriodSeconds: 60
      containers:
        - name: trivet
          image: IMAGE
          args: [@WORDS@]
          env: [{name: TRIVET_SHARDS, value: "@SHARDS@"}]
          resources: {requests: {cpu: @JOBS@, memory: 1Gi}, limits: {memory: 2Gi}}
          volumeMounts: [{name: in, mountPath: /in}, {name: out, mountPath: /out}]
      volumes:
        - {name: in, persistentVolumeClaim: {claimName: CLAIM_OF_RECIPE}}
        - {name: out, persistentVolumeClaim: {claimName: CLAIM_OF_SCENES}}
)";

const char* const kAwsBatch =
    R"({"jobName": "scenes", "jobQueue": "QUEUE", "jobDefinition": "DEFINITION",
 "arrayProperties": {"size": @SHARDS@},
 "retryStrategy": {"attempts": 5, "evaluateOnExit": [
   {"onStatusReason": "Host EC2*", "action": "RETRY"},
   {"onExitCode": "75", "action": "RETRY"},
   {"onExitCode": "*", "action": "EXIT"}]},
 "containerOverrides": {
   "command": [@WORDS@],
   "environment": [{"name": "TRIVET_SHARDS", "value": "@SHARDS@"}]}}
)";

const char* const kParallel = R"sh(#!/bin/bash
# GNU parallel, on one machine; run it again to go on.
exec parallel --quote -j $(( ($(nproc) + @JOBS@ - 1) / @JOBS@ )) --joblog log --resume-failed --retries 3 \
  --termseq TERM,60000,KILL,25 \
  trivet @WORDS@ --shard {}/@SHARDS@ ::: {0..@LAST@}
)sh";

void replace_all(std::string& text, const std::string& mark, const std::string& by) {
  for (size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += by.size())
    text.replace(at, mark.size(), by);
}

std::vector<std::string> words_of(const BatchJob& job, const std::string& recipe,
                                  const std::string& out) {
  std::vector<std::string> words = {"batch",     recipe,
                                    "--count",   std::to_string(job.count),
                                    "--seed",    std::to_string(job.seed),
                                    "--per-tar", std::to_string(job.per_unit),
                                    "--jobs",    std::to_string(job.jobs),
                                    "--out",     out};
  words.insert(words.end(), job.more.begin(), job.more.end());
  return words;
}

std::string joined(const std::vector<std::string>& words, const char* between,
                   std::string (*quoted)(const std::string&)) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + quoted(word);
  return text;
}

// As a word of a shell.
std::string shell_quoted(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,=+:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

// As JSON, which is YAML, too.
std::string json_quoted(const std::string& word) { return Json(word).dump(); }

/// Words of `trivet batch` for a shell, where the template is used; or as JSON, in a container.
std::string words_text(const std::string& engine, const BatchJob& job) {
  if (engine == "slurm" || engine == "parallel")
    return joined(words_of(job, job.recipe, job.out), " ", shell_quoted);
  const std::string name = std::filesystem::path(job.recipe).filename().string();
  return joined(words_of(job, "/in/" + name, "/out"), ", ", json_quoted);
}

}  // namespace

std::string engine_template(const std::string& engine, const BatchJob& job) {
  std::string text = engine == "slurm"        ? kSlurm
                     : engine == "kubernetes" ? kKubernetes
                     : engine == "aws-batch"  ? kAwsBatch
                                              : kParallel;
  const std::uint64_t shards = job.shards > 0 ? job.shards : shards_for(job.count, job.per_unit);
  replace_all(text, "@JOBS@", std::to_string(job.jobs));
  replace_all(text, "@SHARDS@", std::to_string(shards));
  replace_all(text, "@LAST@", std::to_string(shards - 1));
  replace_all(text, "@EACH@", std::to_string((job.count + shards - 1) / shards));
  replace_all(text, "@WORDS@", words_text(engine, job));  // last: they may hold any text
  return text;
}

}  // namespace trivet::farm
