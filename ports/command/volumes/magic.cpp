#include "volume_format.hpp"

namespace discmc::command {
namespace {

struct Magic {
  std::string_view format;
  std::size_t offset;
  std::string_view bytes;
};

using namespace std::string_view_literals;
constexpr Magic magics[] = {
    {"NRRD", 0, "NRRD000"sv},
    {"MetaImage", 0, "ObjectType"sv},
    {"MetaImage", 0, "NDims"sv},
    {"NIfTI", 344, "n+1\0"sv},
    {"NIfTI", 344, "ni1\0"sv},
    {"NIfTI", 4, "n+2\0"sv},
    {"NIfTI", 4, "ni2\0"sv},
    {"VTK", 0, "# vtk DataFile"sv},
    {"VTK XML", 0, "<?xml"sv},
    {"VTK XML", 0, "<VTKFile"sv},
    {"InVesalius", 257, "ustar"sv},
    {"NumPy", 0, "\x93NUMPY"sv},
    {"DICOM", 128, "DICM"sv},
    {"PNG", 0, "\x89PNG"sv},
    {"TIFF", 0, "II*\0"sv},
    {"TIFF", 0, "MM\0*"sv},
    {"TIFF", 0, "II+\0"sv},
    {"TIFF", 0, "MM\0+"sv},
    {"JPEG", 0, "\xff\xd8\xff"sv},
    {"PDF", 0, "%PDF"sv},
    {"HDF5", 0, "\x89HDF"sv},
    {"zip", 0, "PK\x03\x04"sv},
    {"gzip", 0, "\x1f\x8b\x08"sv},
    {"bzip2", 0, "BZh"sv},
    {"xz", 0,
     "\xfd"
     "7zXZ"sv},
    {"zstd", 0, "\x28\xb5\x2f\xfd"sv},
};

std::optional<std::string_view> format_of_head(std::string_view head) {
  for (const Magic& magic : magics)
    if (head.size() >= magic.offset && head.substr(magic.offset, magic.bytes.size()) == magic.bytes)
      return magic.format;
  return std::nullopt;
}

}  // namespace

std::optional<std::string_view> format_of_magic(ByteStream& stream) {
  return format_of_head(stream.peek(magic_bytes));
}

bool is_volume_head(std::string_view head) {
  return format_of_head(head).has_value();
}

}  // namespace discmc::command
