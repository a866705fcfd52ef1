// scan_files VOLUME ISO FOLDER: writes the files that firmware needs to scan a volume, volume.raw
// and scan.hpp.
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <discmc/extractor.hpp>

#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"
#include "text/number_text.hpp"
#include "volumes/volume.hpp"

namespace discmc::simulator {
namespace {

// The memory of the board netduinoplus2 for the arena and two rows of samples. Units: bytes.
constexpr std::uint64_t memory = std::uint64_t{122} << 10;

const char* sample_of(meshing::SampleType type) {
  switch (type) {
    case meshing::SampleType::u8:
      return "uint8_t";
    case meshing::SampleType::u16:
      return "uint16_t";
    case meshing::SampleType::i16:
      return "int16_t";
    default:
      throw std::invalid_argument("its samples are " + std::string(name(type)) +
                                  ", and those of a scanner u8, u16 or i16: use another volume");
  }
}

std::uint64_t arena_bytes(const command::VolumeInfo& info) {
  const std::uint64_t rows = 2 * (info.dims[0] * meshing::sample_bytes(info.type) + 4);
  const std::uint64_t minimum = Extractor16::minimum_bytes({info.dims[0], info.dims[1]});
  if (rows + minimum > memory)
    throw std::invalid_argument("its slices of " + std::to_string(info.dims[0]) + "x" +
                                std::to_string(info.dims[1]) +
                                " voxels are too large for the board: use a smaller volume");
  return memory - rows;
}

void write_header(const command::VolumeInfo& info, double iso, std::ostream& out) {
  const auto spacing = meshing::spacing_nm(info.spacing_mm);
  out << "// Written by scan_files.\n"
         "#include <stddef.h>\n\n"
         "#include <discmc/limits.hpp>\n\n"
         "namespace scan {\n\n"
      << "using Sample = " << sample_of(info.type) << ";\n"
      << "constexpr discmc::Limits limits{" << info.dims[0] << ", " << info.dims[1] << "};\n"
      << "constexpr uint32_t depth = " << info.dims[2] << ";\n"
      << "constexpr int32_t spacing_nm[] = {" << spacing[0] << ", " << spacing[1] << ", "
      << spacing[2] << "};\n"
      << "constexpr int32_t threshold = " << meshing::stored_threshold(info, iso) << ";\n"
      << "constexpr size_t arena_bytes = " << arena_bytes(info) << ";\n\n"
      << "}  // namespace scan\n";
}

void write_samples(command::VolumeReader& volume, std::ostream& out) {
  const command::VolumeInfo& info = volume.info();
  std::vector<char> slice(info.slice_bytes());
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    out.write(slice.data(), static_cast<std::streamsize>(slice.size()));
  }
}

void write_files(const std::string& path, double iso, const std::filesystem::path& folder) {
  const auto volume = command::open_volume(path);
  std::filesystem::create_directories(folder);
  std::ofstream header(folder / "scan.hpp"), samples(folder / "volume.raw", std::ios::binary);
  write_header(volume->info(), iso, header);
  write_samples(*volume, samples);
  if (!header.flush() || !samples.flush())
    throw std::runtime_error(folder.string() +
                             ": cannot be written: free space, or check its "
                             "permissions");
}

int run(int count, char** arguments) {
  const auto iso = count == 4 ? command::finite_number(arguments[2]) : std::nullopt;
  if (!iso) {
    std::cerr << "usage: scan_files VOLUME ISO FOLDER\n";
    return 2;
  }
  try {
    write_files(arguments[1], *iso, arguments[3]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "scan_files: " << arguments[1] << ": " << error.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace discmc::simulator

int main(int count, char** arguments) {
  return discmc::simulator::run(count, arguments);
}
