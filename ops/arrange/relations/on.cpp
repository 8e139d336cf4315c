#include "ops/arrange/relations/on.h"

namespace trivet::relations {

std::vector<Field<On>> On::fields() { return {{"level", &On::level}}; }

}  // namespace trivet::relations
