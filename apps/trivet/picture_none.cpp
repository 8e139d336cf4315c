#include "apps/trivet/picture.h"
#include "core/base/error.h"

namespace trivet::apps {

struct PictureMaker::State {};

PictureMaker::PictureMaker(const PictureRequest&) {
  throw Error(Error::Kind::Environment,
              "this build of trivet makes no pictures; it was configured without EGL");
}
PictureMaker::~PictureMaker() = default;
std::string PictureMaker::png(const Scene&) { return ""; }
std::string PictureMaker::device() const { return ""; }

}  // namespace trivet::apps
