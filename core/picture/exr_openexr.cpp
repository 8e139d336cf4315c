#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {
namespace {

class StringStream : public Imf::OStream {
 public:
  StringStream() : Imf::OStream("image.exr") {}
  void write(const char* data, int size) override {
    if (m_at + size > bytes.size()) bytes.resize(m_at + size);
    std::copy_n(data, size, bytes.begin() + static_cast<std::ptrdiff_t>(m_at));
    m_at += size;
  }
  std::uint64_t tellp() override { return m_at; }
  void seekp(std::uint64_t at) override { m_at = at; }

  std::string bytes;

 private:
  std::uint64_t m_at = 0;
};

}  // namespace

std::string encode_exr(int width, int height, int num_channels, std::span<const float> values) {
  static constexpr const char* kNames[] = {"X", "Y", "Z"};
  try {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;  // the rest gains little
    Imf::FrameBuffer frame;
    for (int c = 0; c < num_channels; ++c) {
      const char* const name = num_channels == 1 ? "Z" : kNames[c];
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      const std::size_t step = sizeof(float) * num_channels;
      frame.insert(name, Imf::Slice(Imf::FLOAT,
                                    reinterpret_cast<char*>(const_cast<float*>(values.data() + c)),
                                    step, step * width));
    }
    StringStream stream;
    {
      Imf::OutputFile file(stream, header, 0);
      file.setFrameBuffer(frame);
      file.writePixels(height);
    }
    return std::move(stream.bytes);
  } catch (const std::exception& error) {
    throw Error(Error::Kind::Environment, "an image cannot be encoded as OpenEXR: %1",
                error.what());
  }
}

}  // namespace trivet
