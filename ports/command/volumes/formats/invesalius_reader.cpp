// Projects of InVesalius: a tar archive with the samples and a property list that describes their
// layout.
#include <utility>

#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

#if defined(DISCMC_WITH_PUGIXML) && defined(DISCMC_WITH_LIBARCHIVE)
#include <archive.h>

#include <array>
#include <pugixml.hpp>

#include "volumes/archive_source.hpp"
#endif

namespace discmc::command {

#if defined(DISCMC_WITH_PUGIXML) && defined(DISCMC_WITH_LIBARCHIVE)
namespace {

// Returns the element after a key of a dictionary.
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

// Returns a member of the archive, found by its name without the folder.
ByteStream member(ByteStream stream, const std::string& name) {
  const std::filesystem::path file = stream.file();
  stream.decode([&](auto in) {
    auto archive = std::make_unique<ArchiveSource>(
        std::move(in), [](auto* reader) { archive_read_support_format_tar(reader); });
    while (const auto found = archive->next_member())
      if (std::filesystem::path(*found).filename() == name) return archive;
    fail(file, "the archive has no whole file " + name,
         "check that this is a project of InVesalius");
  });
  return stream;
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
  // InVesalius stores images upside down: y runs to the front.
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
