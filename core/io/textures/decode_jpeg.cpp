// jpeglib.h needs both, and jerror.h needs it.
#include <cstddef>
#include <cstdio>
// clang-format off
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include "core/base/bad_input.h"
#include "core/io/textures/decoded_image.h"

namespace trivet {
namespace {

// More of them are made to waste time: each decodes the whole picture once more.
constexpr int kMaxScans = 100;
constexpr long kMaxDecoderBytes = 512l << 20;

std::string message_of(j_common_ptr jpeg) {
  char text[JMSG_LENGTH_MAX] = {};
  jpeg->err->format_message(jpeg, text);
  return text;
}

[[noreturn]] void fail_jpeg(const Sentence& reason) { bad_input("is a damaged JPEG: %1", reason); }
void end_by_error(j_common_ptr jpeg) { fail_jpeg(message_of(jpeg)); }

// Most warnings are of damaged data, which libjpeg would fill with grey.
void end_by_warning(j_common_ptr jpeg, int level) {
  const int code = jpeg->err->msg_code;
  if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM)
    fail_jpeg(message_of(jpeg));
}
void be_silent(j_common_ptr) {}

void limit_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMaxScans)
    fail_jpeg(say("it has more than %1 scans", kMaxScans));
}

struct JpegReader {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};

  JpegReader() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = end_by_error;
    errors.emit_message = end_by_warning;
    errors.output_message = be_silent;
    jpeg_create_decompress(&jpeg);
    progress.progress_monitor = limit_scans;
    jpeg.progress = &progress;
    jpeg.mem->max_memory_to_use = kMaxDecoderBytes;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
};

}  // namespace

DecodedImage decode_jpeg(std::string_view bytes) {
  JpegReader reader;
  jpeg_decompress_struct& jpeg = reader.jpeg;
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  check_image_size(jpeg.image_width, jpeg.image_height);
  if (jpeg.num_components == 4) bad_input("is a CMYK JPEG; accepted: grey and colour");
  jpeg.out_color_space = JCS_EXT_RGBA;
  jpeg_start_decompress(&jpeg);
  DecodedImage out{static_cast<int>(jpeg.output_width), static_cast<int>(jpeg.output_height), {}};
  const size_t row_bytes = size_t{4} * jpeg.output_width;
  out.rgba.resize(row_bytes * jpeg.output_height);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = out.rgba.data() + row_bytes * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return out;
}

}  // namespace trivet
