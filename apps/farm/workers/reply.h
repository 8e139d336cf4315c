// Replies of workers, as bytes between processes. Private.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/farm/workers/work.h"

namespace trivet::farm {

/// Work of detectors for a scene, or for many.
struct SceneWork {
  std::int64_t queries = 0, early = 0;     // see DetectionWork
  std::int64_t draws = 0, read_backs = 0;  // of a GPU

  void add(const SceneWork& other);
};

/// Either a scene, or why there is none.
struct WorkerReply {
  std::uint64_t k = 0;
  std::optional<SceneMembers> members;
  std::string error;
  bool is_fatal = false;           // the process is not to be used any more
  std::vector<std::string> notes;  // on the detectors, since the last reply
  SceneWork work;
};

std::string to_bytes(const WorkerReply& reply);
/// Returns nothing for bytes that are no reply.
std::optional<WorkerReply> reply_from(const std::string& bytes);

}  // namespace trivet::farm
