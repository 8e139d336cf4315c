// Who carries an object that leans: the forces that prove its rest say so, not normals alone.
#pragma once

#include "core/scene/transaction.h"
#include "ops/settle/rest.h"

namespace trivet {

/// Marks the links of an object at rest whose centre is not over its contacts, by the forces that
/// balance its weight alone: what bears kCarriedPart of it carries it, whatever the normal, and so
/// does each without which the others do not balance it. Where contacts within kContactTolerance
/// clearances do not balance it, those within kCarryingTolerance (with perfect friction
/// kBalanceTolerance) do, and become links (ObjectContact::across_gap). Other objects have no such
/// marks. A function of shapes, poses, materials and the clearance.
void link_carriers(Transaction& transaction, ObjectId id, const RestRules& rules);

}  // namespace trivet
