#include "core/picture/webp_animation.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <utility>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr float kQuality = 85;

[[noreturn]] void fail(const char* reason) {
  throw Error(Error::Kind::Environment, "an animated WebP: %1", reason);
}

class Picture {
 public:
  explicit Picture(const Image& image) {
    if (!WebPPictureInit(&m_picture)) fail("another version of libwebp");
    m_picture.width = image.width, m_picture.height = image.height;
    m_picture.use_argb = 1;
    if (!WebPPictureImportRGBA(&m_picture, image.rgba.data(), 4 * image.width))
      fail("not enough memory");
  }
  ~Picture() { WebPPictureFree(&m_picture); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  WebPPicture* get() { return &m_picture; }

 private:
  WebPPicture m_picture;
};

}  // namespace

struct WebpAnimation::Encoder {
  WebPAnimEncoder* webp = nullptr;
  int width, height, time = 0;  // time: milliseconds
  ~Encoder() { WebPAnimEncoderDelete(webp); }
};

WebpAnimation::WebpAnimation(int width, int height) : m_encoder(std::make_unique<Encoder>()) {
  if (width < 1 || height < 1 || width > WEBP_MAX_DIMENSION || height > WEBP_MAX_DIMENSION)
    bad_input("an animated WebP of %1 x %2 pixels is not accepted; accepted: 1 to %3", width,
              height, WEBP_MAX_DIMENSION);
  m_encoder->width = width, m_encoder->height = height;
  WebPAnimEncoderOptions options;
  if (!WebPAnimEncoderOptionsInit(&options)) fail("another version of libwebp");
  options.anim_params.loop_count = 1;
  m_encoder->webp = WebPAnimEncoderNew(width, height, &options);
  if (!m_encoder->webp) fail("not enough memory");
}

WebpAnimation::~WebpAnimation() = default;

void WebpAnimation::add(const Image& image, int milliseconds) {
  if (image.width != m_encoder->width || image.height != m_encoder->height)
    bad_input("an animated WebP has pictures of one size");
  WebPConfig config;
  if (!WebPConfigInit(&config)) fail("another version of libwebp");
  config.quality = kQuality;
  Picture picture(image);
  if (!WebPAnimEncoderAdd(m_encoder->webp, picture.get(), m_encoder->time, &config))
    fail(WebPAnimEncoderGetError(m_encoder->webp));
  m_encoder->time += milliseconds;
}

std::string WebpAnimation::bytes() {
  WebPData data;
  WebPDataInit(&data);
  const bool done = WebPAnimEncoderAdd(m_encoder->webp, nullptr, m_encoder->time, nullptr) != 0 &&
                    WebPAnimEncoderAssemble(m_encoder->webp, &data) != 0;
  if (!done) fail(WebPAnimEncoderGetError(m_encoder->webp));
  std::string out(reinterpret_cast<const char*>(data.bytes), data.size);
  WebPDataClear(&data);
  return out;
}

}  // namespace trivet
