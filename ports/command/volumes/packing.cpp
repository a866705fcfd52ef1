#include "packing.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "text/words.hpp"
#include "volume_error.hpp"

#ifdef DISCMC_WITH_LIBARCHIVE
#include <archive.h>

#include "archive_source.hpp"
#endif

namespace discmc::command {
namespace {

using namespace std::string_view_literals;

// The name of the packing is also its program's name.
struct PackingTraits {
  Packing packing;
  std::string_view name;
  std::string_view magic;
};
constexpr PackingTraits packings[] = {
    {Packing::gzip, "gzip", "\x1f\x8b"sv},       {Packing::bzip2, "bzip2", "BZh"sv},
    {Packing::xz, "xz", "\xfd\x37zXZ\0"sv},      {Packing::zstd, "zstd", "\x28\xb5\x2f\xfd"sv},
    {Packing::lz4, "lz4", "\x04\x22\x4d\x18"sv},
};

const PackingTraits& traits_of(Packing packing) {
  return packings[static_cast<std::size_t>(packing)];
}

#ifdef DISCMC_WITH_LIBARCHIVE
template <int filter>
void support(archive* reader) {
  archive_read_append_filter(reader, filter);
  archive_read_support_format_raw(reader);
}

ArchiveSource::Support support_of(Packing packing) {
  switch (packing) {
    case Packing::xz:
      return support<ARCHIVE_FILTER_XZ>;
    case Packing::zstd:
      return support<ARCHIVE_FILTER_ZSTD>;
    case Packing::lz4:
      return support<ARCHIVE_FILTER_LZ4>;
    case Packing::bzip2:
    case Packing::gzip:
      break;
  }
  return support<ARCHIVE_FILTER_BZIP2>;
}
#endif

}  // namespace

std::string_view name(Packing packing) {
  return traits_of(packing).name;
}

std::optional<Packing> packing_of(std::string_view head) {
  for (const PackingTraits& each : packings)
    if (head.substr(0, each.magic.size()) == each.magic) return each.packing;
  return std::nullopt;
}

std::optional<Packing> packing_of_name(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  for (const PackingTraits& each : packings)
    if (extension == packed_endings[1 + static_cast<std::size_t>(each.packing)])
      return each.packing;
  return std::nullopt;
}

std::filesystem::path without_packing(const std::filesystem::path& file) {
  return packing_of_name(file) ? std::filesystem::path(file).replace_extension() : file;
}

std::unique_ptr<ByteSource> unpacked(std::unique_ptr<ByteSource> in, Packing packing,
                                     [[maybe_unused]] const std::filesystem::path& file) {
  // libarchive ignores the checksum of gzip.
  if (packing == Packing::gzip) return inflated(std::move(in));
#ifdef DISCMC_WITH_LIBARCHIVE
  auto source = std::make_unique<ArchiveSource>(std::move(in), support_of(packing));
  source->next_member();
  if (!source->damage().empty()) fail(file, source->damage(), "copy the file again");
  return source;
#else
  fail(file,
       "this is packed by " + std::string(name(packing)) +
           ", and discmc was built without libarchive",
       "unpack it, e.g. with: " + std::string(name(packing)) + " -d " + file.string());
#endif
}

}  // namespace discmc::command
