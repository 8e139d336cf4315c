#include "ops/arrange/relations/sight.h"

namespace trivet::relations {

Vec3 Eye::place(const Outline* b) const {
  if (eye) return *eye;
  return {b->centre.x(), b->centre.y(), b->bottom + eye_height};
}

const char* Looking::wrong(const Terms& r, const IsGiven& is_given) const {
  if (r.b.empty() != eye.has_value()) return TRIVET_SENTENCE("accepted: either \"b\" or \"point\"");
  if (eye && is_given("height"))
    return TRIVET_SENTENCE("accepted: \"height\" with \"b\", a \"point\" has its own");
  return nullptr;
}

}  // namespace trivet::relations
