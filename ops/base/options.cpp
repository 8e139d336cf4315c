#include "ops/base/options.h"

namespace trivet {

double friction_share(const SettleOptions& options) { return options.robust ? kRobustFriction : 1; }

}  // namespace trivet
