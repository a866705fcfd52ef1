// Writes the simulated volume to a file of rows.
//
//   volume FILE X,Y,Z u8|u16
#include <gpio/row_source.hpp>

#include <cstdio>
#include <cstring>
#include <fstream>

int main(int count, char** arguments) {
  std::array<std::uint32_t, 3> dims{};
  auto& [width, height, depth] = dims;
  if (count != 4 || std::sscanf(arguments[2], "%u,%u,%u", &width, &height, &depth) != 3) return 2;
  const bool is_wide = std::strcmp(arguments[3], "u16") == 0;
  const auto type = is_wide ? discmc::meshing::SampleType::u16 : discmc::meshing::SampleType::u8;
  std::vector<std::uint8_t> row(width * discmc::meshing::sample_bytes(type));
  std::ofstream file(arguments[1], std::ios::binary);
  const auto source = discmc::device::simulated_rows(dims, type);
  for (std::uint32_t i = 0; i < height * depth; ++i) {
    source->read(i, row);
    file.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size()));
  }
  return file.flush() ? 0 : 1;
}
