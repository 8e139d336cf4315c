#include "ops/arrange/relations/at.h"

namespace trivet::relations {

std::vector<Field<At>> At::fields() { return {{"point", &At::point, "", true}}; }

}  // namespace trivet::relations
