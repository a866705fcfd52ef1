#include "header.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/label_table.hpp"

#ifdef DISCMC_WITH_PUGIXML
#include <pugixml.hpp>
#endif

namespace discmc::command {
namespace {

// XML without a code of its own (TotalSegmentator), a comment, and Caret.
constexpr std::array<std::uint32_t, 3> codes_of_text = {0, 6, 30};

#ifdef DISCMC_WITH_PUGIXML
std::optional<Srgb> colour_of(const pugi::xml_node& label) {
  return colour_of_shares({label.attribute("Red").value(), label.attribute("Green").value(),
                           label.attribute("Blue").value()});
}

void read_labels(std::string_view xml, VolumeInfo& info) {
  pugi::xml_document document;
  if (!document.load_buffer(xml.data(), xml.size())) return;
  for (const pugi::xml_node volume :
       document.child("CaretExtension").children("VolumeInformation")) {
    const auto layer = whole_number<std::uint32_t>(volume.attribute("Index").value()).value_or(0);
    for (const pugi::xml_node label : volume.child("LabelTable").children("Label")) {
      const auto value = label_value(label.attribute("Key").value());
      const std::string name(trimmed(label.text().get()));
      if (value && *value != LabelValue(0) && !name.empty() && layer < info.frames)
        info.labels.push_back({name, colour_of(label), {*value}, layer});
    }
  }
}
#else
void read_labels(std::string_view, VolumeInfo& info) {
  note(info, "the names of labels are left out, as discmc was built without pugixml");
}
#endif

}  // namespace

void read_label_extensions(ByteStream& stream, std::uint64_t end, bool is_big_endian,
                           VolumeInfo& info) {
  constexpr std::uint32_t head_bytes = 8;
  constexpr std::uint32_t max_bytes = 1U << 24;  // per extension: names of 100,000 labels
  std::array<char, 4> has_extensions{};
  if (stream.position() + has_extensions.size() > end ||
      stream.read(has_extensions.data(), has_extensions.size()) < has_extensions.size() ||
      has_extensions[0] == 0)
    return;
  while (stream.position() + head_bytes <= end) {
    std::array<char, head_bytes> head{};
    if (stream.read(head.data(), head.size()) < head.size()) return;
    const std::uint64_t size = whole_of(head.data(), 4, is_big_endian);
    const std::uint64_t code = whole_of(head.data() + 4, 4, is_big_endian);
    if (size < head_bytes || size > max_bytes || stream.position() + size - head_bytes > end)
      return;
    std::string content(stream.peek(size - head_bytes));
    if (content.size() < size - head_bytes) return;
    stream.skip(content.size());
    content.resize(std::min(content.size(), content.find('\0')));
    const bool is_text =
        std::find(codes_of_text.begin(), codes_of_text.end(), code) != codes_of_text.end();
    if (is_text && content.find("<CaretExtension") != std::string::npos)
      read_labels(trimmed(content), info);
  }
}

}  // namespace discmc::command
