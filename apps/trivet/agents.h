// Options of the agents that the verbs `mcp` and `serve` let in.
#pragma once

#include "apps/mcp/workplace.h"
#include "apps/trivet/common.h"
#include "apps/trivet/foreign_scenes.h"

namespace trivet::apps {

/// Without folder and detector. @param common  outlives what is returned.
mcp::WorkplaceOptions agent_options(const ForeignArguments& foreign, const SettleArguments& settle,
                                    const CommonOptions& common);

}  // namespace trivet::apps
