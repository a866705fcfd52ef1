// write_metaimage FOLDER: writes MetaImage files that write_volumes.py cannot write: 64-bit
// integers, the other byte order, text. Uses MetaIO, the library of the format's authors in ITK and
// VTK.
//
// On Debian, with libvtk9-dev:
//   g++ -I/usr/include/vtk-9.1 write_metaimage.cpp -lvtkmetaio-9.1 -lvtksys-9.1 -o write_metaimage
#include <vtkmetaio/metaImage.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace vtkmetaio;

namespace {

template <class Sample>
void write(const std::string& file, MET_ValueEnumType type, double step, double first,
           bool is_binary = true, bool is_big_endian = false) {
  std::vector<Sample> samples;
  for (int i = 0; i < 60; ++i) samples.push_back(static_cast<Sample>(i * step + first));
  MetaImage image(5, 3, 4, 0.5F, 0.75F, 2, type, 1, samples.data());
  const double origin[] = {10, -20, 30.5};
  image.Position(origin);
  image.BinaryData(is_binary);
  image.CompressedData(false);
  if (is_big_endian) image.ElementByteOrderSwap();
  image.Write(file.c_str());
}

}  // namespace

// The samples are those of sample_at() in volume_files.hpp.
int main(int, char** arguments) {
  const std::string folder = std::string(arguments[1]) + "/";
  write<std::uint64_t>(folder + "u64-little.mha", MET_ULONG_LONG, 3e17, 0);
  write<std::int64_t>(folder + "i64-little.mha", MET_LONG_LONG, 3e17, -9e18);
  write<std::int16_t>(folder + "i16-little-text.mha", MET_SHORT, 1000, -30000, false);
  write<std::int16_t>(folder + "i16-big.mha", MET_SHORT, 1000, -30000, true, true);
}
