// Projects of InVesalius: an archive of tar with the samples and, before or behind them, a property
// list that describes how they are stored.
#include <algorithm>
#include <utility>

#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

#if defined(DISCMC_WITH_PUGIXML) && defined(DISCMC_WITH_LIBARCHIVE)
#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <new>
#include <pugixml.hpp>
#endif

namespace discmc::command {

#if defined(DISCMC_WITH_PUGIXML) && defined(DISCMC_WITH_LIBARCHIVE)
namespace {

// A file of the archive, found by its name without the folder.
class Member final : public ByteSource {
 public:
  Member(ByteStream stream, std::string_view name)
      : stream_(std::move(stream)), archive_(archive_read_new()) {
    if (archive_ == nullptr) throw std::bad_alloc();
    archive_read_support_format_tar(archive_);
    bool is_found = archive_read_open(archive_, this, nullptr, give, nullptr) == ARCHIVE_OK;
    archive_entry* entry = nullptr;
    do {
      is_found = is_found && archive_read_next_header(archive_, &entry) == ARCHIVE_OK;
    } while (is_found && name_of(entry) != name);
    if (is_found) return;
    archive_read_free(archive_);
    fail(stream_.file(), "the archive has no whole file " + std::string(name),
         "check that this is a project of InVesalius");
  }
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;
  ~Member() override { archive_read_free(archive_); }

  std::size_t read(void* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count) {
      const la_ssize_t got =
          archive_read_data(archive_, static_cast<char*>(bytes) + done, count - done);
      if (got <= 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

  std::uint64_t max_left() const override { return unbounded; }
  std::string damage() const override { return stream_.damage(); }

 private:
  static la_ssize_t give(archive*, void* member, const void** bytes) {
    auto& self = *static_cast<Member*>(member);
    *bytes = self.block_.data();
    return static_cast<la_ssize_t>(self.stream_.read(self.block_.data(), self.block_.size()));
  }

  static std::string_view name_of(archive_entry* entry) {
    const char* path = archive_entry_pathname(entry);
    const std::string_view name = path == nullptr ? "" : path;
    return name.substr(std::min(name.rfind('/') + 1, name.size()));
  }

  ByteStream stream_;
  archive* archive_;
  std::array<char, 65536> block_;
};

// What follows a key in a dictionary.
pugi::xml_node value_of(const std::filesystem::path& file, const pugi::xml_node& dictionary,
                        std::string_view key) {
  for (const pugi::xml_node& node : dictionary.children("key"))
    if (node.text().get() == key) return node.next_sibling();
  fail(file, "main.plist has no " + std::string(key), "save the project again");
}

std::vector<std::string> items(const pugi::xml_node& array) {
  std::vector<std::string> texts;
  for (const pugi::xml_node& item : array.children()) texts.emplace_back(item.text().get());
  return texts;
}

std::array<std::string, 3> three_of(const std::filesystem::path& file,
                                    const pugi::xml_node& dictionary, std::string_view key) {
  const auto texts = items(value_of(file, dictionary, key));
  if (texts.size() != 3)
    fail(file, std::string(key) + " holds " + std::to_string(texts.size()) + " numbers",
         "save the project again");
  return {texts[0], texts[1], texts[2]};
}

ByteStream member(ByteStream archive, std::string_view name) {
  const std::filesystem::path file = archive.file();
  return {file, std::make_unique<Member>(std::move(archive), name)};
}

}  // namespace

std::unique_ptr<VolumeReader> open_invesalius(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  if (stream.is_read_once())
    fail(file, "projects of InVesalius cannot be read from a pipe",
         "store the project in a file first");
  ByteStream list = member(std::move(stream), "main.plist");
  constexpr std::size_t max_list_bytes = 1U << 20;
  const std::string text(list.peek(max_list_bytes));
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const pugi::xml_node project = document.child("plist").child("dict");
  const pugi::xml_node matrix = value_of(file, project, "matrix");

  VolumeInfo info;
  info.format = "InVesalius";
  const std::string type = value_of(file, matrix, "dtype").text().get();
  if (type != "int16") fail_type(file, type);
  info.type = SampleType::i16;
  const auto shape = three_of(file, matrix, "shape");
  set_dims(info, file,
           {integer(file, "shape", shape[2]), integer(file, "shape", shape[1]),
            integer(file, "shape", shape[0])});
  const auto spacing = three_of(file, project, "spacing");
  DeclaredPlace place;
  place.set_unit("mm");
  // InVesalius stores images upside down: its y runs to the front.
  place.spacing = {real(file, "spacing", spacing[0]), -real(file, "spacing", spacing[1]),
                   real(file, "spacing", spacing[2])};
  set_place(info, place, options);
  note(info, "y runs backwards: InVesalius stores images upside down");
  const std::string name = value_of(file, matrix, "filename").text().get();
  ByteStream samples = member(open_content(file), name);
  constexpr bool is_big_endian = false;
  return std::make_unique<SliceStream>(std::move(info), std::move(samples), is_big_endian);
}
#else
std::unique_ptr<VolumeReader> open_invesalius(ByteStream stream, const VolumeOptions&) {
  fail(stream.file(), "this discmc was built without libarchive or pugixml",
       "unpack matrix.dat with tar and give it with --dims and --type i16");
}
#endif

}  // namespace discmc::command
