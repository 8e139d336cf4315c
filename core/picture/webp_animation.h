// Pictures of one size as an animated WebP.
#pragma once

#include <memory>
#include <string>

#include "core/base/image.h"

namespace trivet {

class WebpAnimation {
 public:
  /// @param width, height  pixels, 1 to 16383. @throws Error (BadInput) beyond; (Environment) for
  ///   lack of memory.
  WebpAnimation(int width, int height);
  ~WebpAnimation();
  WebpAnimation(const WebpAnimation&) = delete;
  WebpAnimation& operator=(const WebpAnimation&) = delete;

  /// The next picture. @param milliseconds  for which it is shown, at least 1.
  void add(const Image& image, int milliseconds);
  /// The file, played once. Ends the film. @throws Error (Environment) with libwebp's reason.
  std::string bytes();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> m_encoder;
};

}  // namespace trivet
