// Private to gpu: converts the frame of a query for the shaders.
#pragma once

#include "core/candidates/zlist_frame.h"
#include "gpu/zlist/lists.h"

namespace trivet {

/// Uploads the meshes that are not in graphics memory yet.
/// @return a view without fixed bodies if the meshes do not fit.
ZListView make_view(const FirstContactQuery& query, const ZListFrame& frame,
                    ZListMeshCache& meshes);

}  // namespace trivet
