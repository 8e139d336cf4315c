#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/bad_input.h"
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

class BytesStream : public Imf::IStream {
 public:
  explicit BytesStream(const std::string& bytes) : Imf::IStream("image.exr"), m_bytes(bytes) {}
  bool read(char data[], int size) override {
    if (size < 0 || m_at > m_bytes.size() || std::size_t(size) > m_bytes.size() - m_at)
      throw std::runtime_error("it ends early");
    std::memcpy(data, m_bytes.data() + m_at, std::size_t(size));
    m_at += std::size_t(size);
    return m_at < m_bytes.size();
  }
  std::uint64_t tellg() override { return m_at; }
  void seekg(std::uint64_t at) override { m_at = at; }

 private:
  const std::string& m_bytes;
  std::uint64_t m_at = 0;
};

FloatImage sized(const Imath::Box2i& window) {
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > kMaxFloatImageSide || height > kMaxFloatImageSide ||
      width * height > kMaxFloatImagePixels)
    bad_input("an image of %1 x %2 pixels; accepted: up to %3 a side, %4 together", width, height,
              kMaxFloatImageSide, kMaxFloatImagePixels);
  return {int(width), int(height), std::vector<float>(std::size_t(3 * width * height))};
}

FloatImage decoded(Imf::InputFile& file) {
  const Imath::Box2i window = file.header().dataWindow();
  FloatImage out = sized(window);
  const Imf::ChannelList& channels = file.header().channels();
  const bool grey = !channels.findChannel("R") && channels.findChannel("Y");
  const std::size_t step = 3 * sizeof(float), row = step * std::size_t(out.width);
  Imf::FrameBuffer frame;
  const char* const names[] = {grey ? "Y" : "R", "G", "B"};
  for (int c = 0; c < (grey ? 1 : 3); ++c)
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, out.rgb.data() + c, window, step, row));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  for (std::size_t i = 0; i < out.rgb.size(); ++i) {
    if (grey) out.rgb[i] = out.rgb[i - i % 3];
    if (!std::isfinite(out.rgb[i]) || out.rgb[i] < 0) out.rgb[i] = 0;
  }
  return out;
}

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

FloatImage decode_exr(const std::string& bytes) {
  try {
    BytesStream stream(bytes);
    Imf::InputFile file(stream, 0);
    return decoded(file);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    bad_input("no OpenEXR image: %1", std::string(error.what()));
  }
}

}  // namespace trivet
