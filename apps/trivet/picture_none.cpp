#include "apps/trivet/picture.h"
#include "core/base/error.h"

namespace trivet::apps {
namespace {

[[noreturn]] void refuse() {
  throw Error(Error::Kind::Environment,
              "this build of trivet makes no pictures (configured without EGL)");
}

}  // namespace

struct PictureMaker::State {};

PictureMaker::PictureMaker(const PictureRequest&) { refuse(); }
PictureMaker::~PictureMaker() = default;
std::string PictureMaker::png(const Scene&) { return ""; }
std::string PictureMaker::device() const { return ""; }

std::string png_of(const Image&) { refuse(); }

}  // namespace trivet::apps
