// NumPy arrays, .npy, whose axes have no names.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "header.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/array_name.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"

#ifdef DISCMC_WITH_LIBARCHIVE
#include <archive.h>

#include "volumes/archive_source.hpp"
#endif

namespace discmc::command {

std::unique_ptr<VolumeReader> numpy_volume(ByteStream stream, const std::string& format,
                                           const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const NumpyHeader header = read_numpy_header(stream);
  const auto type = numpy_type(header.type);
  if (!type) fail_type(file, header.type);
  VolumeInfo info;
  info.format = format;
  info.type = type->type;
  const ArrayLayout layout = find_volume_axes(info, file, header.shape, options);
  set_place(info, {}, options);
  bool is_big_endian = type->is_big_endian;
  if (type->is_half) {
    stream.decode(
        [is_big_endian](auto in) { return floats_of_halves(std::move(in), is_big_endian); });
    is_big_endian = is_native_big_endian();
  }
  return array_volume(std::move(info), std::move(stream), layout, is_big_endian);
}

std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options) {
  return numpy_volume(std::move(stream), "NumPy", options);
}

#ifdef DISCMC_WITH_LIBARCHIVE
namespace {

constexpr std::string_view ending = ".npy";

std::unique_ptr<ArchiveSource> opened(const std::filesystem::path& file) {
  return std::make_unique<ArchiveSource>(
      file, [](archive* reader) { archive_read_support_format_zip(reader); });
}

// Returns the name of the array in a member: "/volume" for "volume.npy"; empty for other members.
std::string name_of_array(const std::string& member) {
  if (member.size() <= ending.size() ||
      member.compare(member.size() - ending.size(), ending.size(), ending) != 0)
    return {};
  return "/" + member.substr(0, member.size() - ending.size());
}

// Reads a member and keeps the archive open for the next one.
class Member final : public ByteSource {
 public:
  explicit Member(ArchiveSource& archive) : archive_(archive) {}
  std::size_t read(void* bytes, std::size_t count) override { return archive_.read(bytes, count); }
  std::uint64_t max_left() const override { return unbounded; }
  std::string damage() const override { return archive_.damage(); }

 private:
  ArchiveSource& archive_;
};

std::vector<NamedArray> arrays_of(const std::filesystem::path& file) {
  const auto archive = opened(file);
  std::vector<NamedArray> arrays;
  while (const auto member = archive->next_member()) {
    const std::string name = name_of_array(*member);
    if (name.empty()) continue;
    ByteStream stream(file, std::make_unique<Member>(*archive));
    const NumpyHeader header = read_numpy_header(stream);
    if (numpy_type(header.type) && header.shape.sizes.size() >= 2)
      arrays.push_back({name, header.shape.sizes});
  }
  if (!archive->damage().empty()) fail(file, archive->damage(), "copy or save the file again");
  return arrays;
}

}  // namespace

std::unique_ptr<VolumeReader> open_npz(const std::filesystem::path& name,
                                       const VolumeOptions& options) {
  const ArrayName parts = array_name(name);
  // Opens the file so that errors of the path are reported.
  if (ByteStream(parts.file).is_read_once())
    fail(name, "archives of NumPy cannot be read from a pipe", "store it in a file");
  const std::string asked =
      parts.array.empty() ? only_array(name, arrays_of(parts.file)) : parts.array;
  auto archive = opened(parts.file);
  while (const auto member = archive->next_member())
    if (name_of_array(*member) == asked)
      return numpy_volume(ByteStream(name, std::move(archive)), "NumPy, npz", options);
  fail_no_array(name, asked, arrays_of(parts.file));
}
#else
std::unique_ptr<VolumeReader> open_npz(const std::filesystem::path& name, const VolumeOptions&) {
  fail(name, "this discmc was built without libarchive", "unzip it and give the .npy in it");
}
#endif

}  // namespace discmc::command
