#include "apps/farm/batch/templates.h"

#include <algorithm>
#include <cstdint>

namespace trivet::farm {
namespace {

// Shards of at least a unit; Slurm's arrays have 1,000 tasks at most unless configured otherwise.
std::uint64_t shards_for(std::uint64_t count, std::uint64_t per_unit) {
  const std::uint64_t units = (count + per_unit - 1) / per_unit;
  return std::clamp<std::uint64_t>(units, 2, 200);
}

const char* const kSlurm = R"(#!/bin/bash
# sbatch this. Exit 75 means: come again; slurm.conf may have RequeueExit=75.
#SBATCH --array=0-@LAST@%50 --requeue --open-mode=append --time=2:00:00
#SBATCH --mem=2G --cpus-per-task=1 --signal=B:TERM@60
export TRIVET_SHARDS=@SHARDS@
exec trivet batch @RECIPE@ --count @COUNT@ --seed @SEED@ --per-tar @PER@ --jobs 1 --out "$SLURM_SUBMIT_DIR/out"
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
          args: [batch, /in/@RECIPE@, --count, "@COUNT@", --seed, "@SEED@", --per-tar, "@PER@", --jobs, "1", --out, /out]
          env: [{name: TRIVET_SHARDS, value: "@SHARDS@"}]
          resources: {requests: {cpu: 1, memory: 1Gi}, limits: {memory: 2Gi}}
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
   "command": ["batch", "/in/@RECIPE@", "--count", "@COUNT@", "--seed", "@SEED@", "--per-tar", "@PER@", "--jobs", "1", "--out", "/out"],
   "environment": [{"name": "TRIVET_SHARDS", "value": "@SHARDS@"}]}}
)";

const char* const kParallel = R"sh(#!/bin/bash
# GNU parallel, on one machine; run it again to go on.
parallel -j "$(nproc)" --joblog log --resume-failed --retries 3 --termseq TERM,60000,KILL,25 \
  trivet batch @RECIPE@ --count @COUNT@ --seed @SEED@ --per-tar @PER@ --jobs 1 \
  --shard {}/@SHARDS@ --out out ::: {0..@LAST@}
)sh";

void replace_all(std::string& text, const std::string& mark, const std::string& by) {
  for (size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += by.size())
    text.replace(at, mark.size(), by);
}

}  // namespace

std::string engine_template(const std::string& engine, const std::string& recipe,
                            std::uint64_t count, std::uint64_t seed, std::uint64_t per_unit) {
  std::string text = engine == "slurm"        ? kSlurm
                     : engine == "kubernetes" ? kKubernetes
                     : engine == "aws-batch"  ? kAwsBatch
                                              : kParallel;
  const std::uint64_t shards = shards_for(count, per_unit);
  replace_all(text, "@RECIPE@", recipe);
  replace_all(text, "@COUNT@", std::to_string(count));
  replace_all(text, "@SEED@", std::to_string(seed));
  replace_all(text, "@PER@", std::to_string(per_unit));
  replace_all(text, "@SHARDS@", std::to_string(shards));
  replace_all(text, "@LAST@", std::to_string(shards - 1));
  return text;
}

}  // namespace trivet::farm
