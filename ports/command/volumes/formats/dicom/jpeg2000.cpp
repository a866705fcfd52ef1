#include "decoders.hpp"

#include <openjpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace discmc::command {
namespace {

struct Input {
  const std::vector<std::uint8_t>& bytes;
  std::size_t at = 0;
};

OPJ_SIZE_T read(void* buffer, OPJ_SIZE_T count, void* user) {
  auto& input = *static_cast<Input*>(user);
  const std::size_t copied = std::min<std::size_t>(count, input.bytes.size() - input.at);
  if (copied == 0) return static_cast<OPJ_SIZE_T>(-1);
  std::memcpy(buffer, input.bytes.data() + input.at, copied);
  input.at += copied;
  return copied;
}

OPJ_OFF_T skip(OPJ_OFF_T count, void* user) {
  auto& input = *static_cast<Input*>(user);
  if (count < 0 || static_cast<std::size_t>(count) > input.bytes.size() - input.at) return -1;
  input.at += static_cast<std::size_t>(count);
  return count;
}

OPJ_BOOL seek(OPJ_OFF_T offset, void* user) {
  auto& input = *static_cast<Input*>(user);
  if (offset < 0 || static_cast<std::size_t>(offset) > input.bytes.size()) return OPJ_FALSE;
  input.at = static_cast<std::size_t>(offset);
  return OPJ_TRUE;
}

using Stream = std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)>;
using Codec = std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)>;
using Image = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;

Stream stream_of(Input& input) {
  Stream stream(opj_stream_default_create(OPJ_TRUE), &opj_stream_destroy);
  opj_stream_set_user_data(stream.get(), &input, nullptr);
  opj_stream_set_user_data_length(stream.get(), input.bytes.size());
  opj_stream_set_read_function(stream.get(), read);
  opj_stream_set_skip_function(stream.get(), skip);
  opj_stream_set_seek_function(stream.get(), seek);
  return stream;
}

// Some programs write the boxes of a .jp2 file around the code stream.
OPJ_CODEC_FORMAT format(const std::vector<std::uint8_t>& bytes) {
  constexpr std::uint8_t start_of_code_stream[] = {0xff, 0x4f};
  const bool is_bare =
      bytes.size() >= 2 &&
      std::equal(std::begin(start_of_code_stream), std::end(start_of_code_stream), bytes.begin());
  return is_bare ? OPJ_CODEC_J2K : OPJ_CODEC_JP2;
}

bool is_of_size(const opj_image_t& image, PictureSize size) {
  const opj_image_comp_t& only = image.comps[0];
  return image.numcomps == 1 && only.w == size.columns && only.h == size.rows && only.dx == 1 &&
         only.dy == 1;
}

template <class Sample>
void store(const OPJ_INT32* values, std::size_t count, unsigned char* samples) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto sample = static_cast<Sample>(values[i]);
    std::memcpy(samples + i * sizeof sample, &sample, sizeof sample);
  }
}

}  // namespace

std::string decode_jpeg2000(const std::vector<std::uint8_t>& bytes, PictureSize size,
                            unsigned char* samples) {
  Input input{bytes};
  const Stream stream = stream_of(input);
  const Codec codec(opj_create_decompress(format(bytes)), &opj_destroy_codec);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  opj_image_t* header = nullptr;
  if (opj_setup_decoder(codec.get(), &parameters) == OPJ_FALSE ||
      opj_read_header(stream.get(), codec.get(), &header) == OPJ_FALSE)
    return "the JPEG 2000 header is damaged";
  const Image image(header, &opj_image_destroy);
  // Checks the size before OpenJPEG allocates the picture.
  if (image->numcomps < 1 || !is_of_size(*image, size))
    return "the JPEG 2000 picture has another size than the header";
  if (opj_decode(codec.get(), stream.get(), image.get()) == OPJ_FALSE ||
      image->comps[0].data == nullptr || !is_of_size(*image, size))
    return "the JPEG 2000 data is damaged";
  const std::size_t count = std::size_t{size.columns} * size.rows;
  if (size.sample_bytes == 1)
    store<std::uint8_t>(image->comps[0].data, count, samples);
  else if (size.sample_bytes == 2)
    store<std::uint16_t>(image->comps[0].data, count, samples);
  else
    store<std::uint32_t>(image->comps[0].data, count, samples);
  return {};
}

}  // namespace discmc::command
