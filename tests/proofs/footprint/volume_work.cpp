// Encodes one volume as every kind of stream, and counts the instructions. The file volume.raw,
// written by payloads.cpp, has a FileHeader and then the samples: x fastest, little-endian.
#include <discmc/fraction_slice_encoder.hpp>
#include <semihosting.hpp>

#include "counted_streams.hpp"

using namespace discmc;
using namespace discmc::test;

struct FileHeader {
  uint32_t width, height, slices;
  int32_t threshold;
  uint32_t sample_bytes;
};
static FileHeader header;

class RowsOfFile {
 public:
  RowsOfFile() : file_(semihosting::open_to_read("volume.raw")) {
    semihosting::read(file_, &header, sizeof header);
  }
  // A missing row would change the length of the stream.
  template <class Sample>
  void read(Sample* row) {
    semihosting::read(file_, row, header.width * sizeof *row);
  }

 private:
  intptr_t file_;
};

template <class Sample>
static bool count_all(const Volume& volume) {
  const auto count_levels = [&](uint8_t levels) {
    return count_slices<Sample, FractionSliceEncoder<Sample>>("bytes", volume, 0, RowsOfFile{},
                                                              levels);
  };
  return count_kinds<Sample, RowsOfFile>("bytes", volume) && count_levels(2) && count_levels(4);
}

int main() {
  RowsOfFile{};  // for the header
  const Volume volume{{header.width, header.height}, header.slices, header.threshold};
  const bool good =
      header.sample_bytes == 1 ? count_all<uint8_t>(volume) : count_all<uint16_t>(volume);
  board::report("voxels", volume.voxels());
  board::stop(good);
}
