// Checks of a machine before a farm's jobs start, for `trivet doctor`: memory, disk, importer, ...
#pragma once

#include <string>
#include <vector>

namespace trivet::farm {

struct NodeCheck {
  enum class Verdict {
    Ok,
    Note,     // works otherwise than one may expect
    Lacking,  // batches fail here
  };
  std::string name;
  Verdict verdict = Verdict::Ok;
  std::string text;  // what was found, and what is needed
};
const char* to_string(NodeCheck::Verdict verdict);  // "ok", "note", "lacking"

struct NodeNeeds {
  std::string out;          // folder of the batch; empty: it is not looked at
  double memory_mb = 1024;  // available to all workers together
  double disk_mb = 1024;    // free in the folder
};

/// Importer, memory (of the cgroup, too), file descriptors, clock, and the folder: free space,
/// whether files can be written, and published by hard links. Leaves nothing behind.
std::vector<NodeCheck> check_node(const NodeNeeds& needs);

}  // namespace trivet::farm
