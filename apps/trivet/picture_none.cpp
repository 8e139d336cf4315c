#include "apps/trivet/picture.h"
#include "core/base/error.h"

namespace trivet::apps {

std::unique_ptr<GlPictures> make_gl_pictures(int) {
  throw Error(Error::Kind::Environment,
              "this build of trivet has no OpenGL (configured without EGL); accepted: --renderer "
              "path");
}

}  // namespace trivet::apps
