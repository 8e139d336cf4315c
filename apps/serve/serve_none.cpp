#include "apps/serve/serve.h"
#include "core/base/error.h"

namespace trivet::serve {

void serve(const ServeOptions&) {
  throw Error(Error::Kind::Environment,
              "this trivet was built without `serve`; Debian: libboost-dev, prometheus-cpp-dev");
}

}  // namespace trivet::serve
