// Private to gpu: the frame of a query in the shaders' terms.
#pragma once

#include "core/contact/zlist_frame.h"
#include "gpu/zlist_lists.h"

namespace trivet {

/// Sends the meshes that are not in graphics memory yet.
/// @return a view without fixed bodies when the meshes do not fit.
ZListView make_view(const FirstContactQuery& query, const ZListFrame& frame,
                    ZListMeshCache& meshes);

}  // namespace trivet
