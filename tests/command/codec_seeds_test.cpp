// The fuzz corpus of volume_readers has an input for each codec that the readers accept.
#include "command.hpp"
#include "dicom_files.hpp"
#include "tiff_writer.hpp"

namespace {

using namespace volume_files;
using tiff_writer::whole;

const fs::path corpus = fs::path(DISCMC_SOURCE_DIR) / "fuzz/corpus/volume_readers";

const std::string standard = "1.2.840.10008.1.2";

// The UIDs of transfer syntaxes: those of the standard, some undefined ones, and one of GE.
std::vector<std::string> transfer_syntaxes() {
  std::vector<std::string> all = {standard, "1.2.840.113619.5.2"};
  for (int i = 1; i < 10; ++i) all.push_back(standard + "." + std::to_string(i));
  for (int i = 90; i < 100; ++i) all.push_back(standard + ".1." + std::to_string(i));
  for (int i = 1; i < 256; ++i) all.push_back(standard + ".4." + std::to_string(i));
  return all;
}

// The numbers of compressions that TIFF or LibTIFF defines, and some undefined ones.
std::set<std::uint32_t> tiff_compressions() {
  std::set<std::uint32_t> all;
  for (const auto& [first, last] : {std::pair(1U, 10U),
                                    {32766U, 32773U},
                                    {32809U, 32809U},
                                    {32895U, 32909U},
                                    {32946U, 32947U},
                                    {34661U, 34677U},
                                    {34712U, 34712U},
                                    {34887U, 34934U},
                                    {50000U, 50005U}})
    for (std::uint32_t i = first; i <= last; ++i) all.insert(i);
  return all;
}

// The syntax that the header of a file names.
std::string transfer_syntax(const std::string& bytes) {
  const std::string tag("\x02\0\x10\0UI", 6);
  const std::size_t at = bytes.find(tag);
  if (at == std::string::npos || at + 8 > bytes.size()) return {};
  const std::string uid = bytes.substr(at + 8, static_cast<unsigned char>(bytes[at + 6]));
  return uid.substr(0, uid.find('\0'));
}

// The compression of the first page of a little-endian file; 0 for other files.
std::uint32_t tiff_compression(const std::string& bytes) {
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;)
      value = value << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    return value;
  };
  if (bytes.rfind("II*", 0) != 0) return 0;
  const std::size_t directory = number(4, 4);
  for (std::size_t i = 0; i < number(directory, 2); ++i)
    if (const std::size_t tag = directory + 2 + 12 * i;
        number(tag, 2) == tiff_writer::tag::compression)
      return number(tag + 8, 2);
  return 0;
}

// Inputs by the results of codec() for their files. place: the index of the file's name in
// volume_readers.cpp.
template <class Codec>
auto seeds(std::uint8_t place, const std::string& name, Codec codec) {
  std::set<decltype(codec(std::string()))> found;
  const Folder folder;
  for (const auto& entry : fs::directory_iterator(corpus)) {
    const std::string input = contents(entry.path());
    constexpr std::size_t before_file = 3;
    if (input.size() < before_file || static_cast<unsigned char>(input[0]) != place) continue;
    const std::string file = input.substr(before_file);
    VolumeOptions options;
    constexpr unsigned char first_channel = 24;
    const auto choice = static_cast<unsigned char>(input[1]);
    if (choice == first_channel) options.channel = 0;
    if (choice % first_channel == 0 && error_of(folder.write(name, file), options).empty())
      found.insert(codec(file));
  }
  return found;
}

TEST_CASE_FIXTURE(Folder,
                  "every accepted DICOM transfer syntax has a fuzz input that is read to its end") {
  const std::set<std::string> found = seeds(12, "v.dcm", transfer_syntax);
  std::size_t accepted = 0;
  for (const std::string& uid : transfer_syntaxes()) {
    const std::string bytes = dicom_files::slice(0).file(dicom_files::Order::little_endian, uid);
    const std::string refused = error_of(write("v.dcm", bytes));
    const bool is_deflated =
        uid == standard + ".1.99" || uid == standard + ".4.95" || uid == standard + ".4.205";
    if (contains(refused, "('" + uid + "')") ||
        (is_deflated && contains(refused, "deflated as a whole")))
      continue;
    INFO(uid);
    CHECK(found.count(uid) == 1);
    ++accepted;
  }
  CHECK(accepted >= 15);
}

TEST_CASE_FIXTURE(Folder,
                  "every accepted TIFF compression has a fuzz input that is read to its end") {
  const std::set<std::uint32_t> found = seeds(14, "v.tif", tiff_compression);
  std::size_t accepted = 0;
  for (const std::uint32_t number : tiff_compressions()) {
    tiff_writer::TiffWriter file;
    file.page(5, 3, u8.substr(0, 15), {{tiff_writer::tag::compression, whole({number})}});
    const std::string refused = error_of(write("v.tif", file.bytes()));
    // SGILog of 24 and 32 bits is only for colours, which are not read.
    if (contains(refused, "its compression, number") || number == 34676 || number == 34677)
      continue;
    INFO(number);
    CHECK(found.count(number) == 1);
    ++accepted;
  }
  CHECK(accepted >= 3);
}

}  // namespace
