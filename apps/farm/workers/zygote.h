// The process that has read all models, and the workers that are forked from it. Private.
//
//   parent, without models --- 'F' ---> zygote --- fork ---> worker
//          <--- 'R' ready, 'E' error, 'W' a worker and its socket, 'D' a worker's death ---
//          <------------------------- k, scenes ------------------------------->
//
// A fork copies one thread only, so that the zygote never has more, and no OpenGL: what a worker
// needs of these it makes itself. When the parent dies so do all others.
#pragma once

#include <sys/types.h>

#include "apps/farm/workers/work.h"
#include "core/io/process/local_sockets.h"

namespace trivet::farm {

struct Zygote {
  pid_t id = -1;
  Descriptor control;  // SEQPACKET
};

/// Forks it; it begins to read the models. The caller has one thread.
/// @param work  must live on until then: the zygote has a copy of the memory.
Zygote start_zygote(const Work& work, const WorkLimits& limits);

/// 'W' and 'D', followed by these numbers.
struct WorkerNews {
  char kind = 0;
  pid_t id = -1;
  int status = 0;  // of 'D', as waitpid() has it
};

/// Message to a worker.
struct SceneRequest {
  std::uint64_t k = 0;
  /// By BVHs, and no other at the same time: its process, or that of another one, has ended.
  bool alone = false;
};

/// Serves request after request from a socket until it is closed. Does not return.
[[noreturn]] void serve_scenes(const Work& work, const LoadedModels& models,
                               const WorkLimits& limits, std::uint64_t worker, int socket);

}  // namespace trivet::farm
