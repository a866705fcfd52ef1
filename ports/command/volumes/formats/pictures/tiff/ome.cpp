#include "descriptions.hpp"

#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_error.hpp"

#ifdef DISCMC_WITH_PUGIXML
#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <system_error>

#include "text/number_text.hpp"
#endif

namespace discmc::command {

bool is_ome(std::string_view description) {
  const std::string_view text = trimmed(description);
  constexpr std::string_view end = "OME>";
  return !text.empty() && text.front() == '<' && text.size() > end.size() &&
         text.substr(text.size() - end.size()) == end;
}

#ifdef DISCMC_WITH_PUGIXML
namespace {

// Returns the name without its namespace prefix.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<pugi::xml_node> children(const pugi::xml_node& parent, std::string_view name) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& node : parent.children())
    if (local_name(node) == name) found.push_back(node);
  return found;
}

pugi::xml_node child(const pugi::xml_node& parent, std::string_view name) {
  const auto found = children(parent, name);
  return found.empty() ? pugi::xml_node() : found.front();
}

// The OME-XML of a file, or of the metadata file that it names.
class OmeXml {
 public:
  OmeXml(const std::filesystem::path& file, const std::string& description) : file_(file) {
    parse(description);
    uuid_ = root().attribute("UUID").value();
    const pugi::xml_node elsewhere = child(root(), "BinaryOnly");
    if (!elsewhere) return;
    const auto metadata = beside(file, elsewhere.attribute("MetadataFile").value());
    std::ifstream in(metadata, std::ios::binary);
    if (!in || std::filesystem::is_directory(metadata))
      fail(file, "the OME-XML is in " + shown(metadata.filename().string()) + ", which is missing",
           "put that file beside it");
    parse(std::string(std::istreambuf_iterator<char>(in), {}));
  }

  const std::filesystem::path& file() const { return file_; }
  pugi::xml_node root() const { return document_.document_element(); }

  /// Returns the file with the pages of a TiffData element.
  std::filesystem::path file_of(const pugi::xml_node& tiff_data) const {
    const pugi::xml_node uuid = child(tiff_data, "UUID");
    const std::string_view name = uuid.attribute("FileName").value();
    const bool is_own = !uuid_.empty() && uuid_ == uuid.text().get();
    if (!uuid || is_own) return file_;
    if (name.empty())
      fail(file_, "the OME-XML names a file only by an identifier", "export it again, as one file");
    if (leads_out(name) && names_of_files().size() == 1) return file_;  // the file was moved
    auto file = beside(file_, name);
    std::error_code unknown;
    if (std::filesystem::exists(file, unknown)) return file;
    if (!names_of_files_) names_of_files_ = names_of_files();
    if (names_of_files_->size() == 1) return file_;  // the file was renamed
    fail(file_, "the file " + shown(name) + " of its set is missing", "put it beside the others");
  }

  std::uint64_t count(const pugi::xml_node& node, const std::string& attribute,
                      std::uint64_t otherwise) const {
    const pugi::xml_attribute text = node.attribute(attribute.c_str());
    if (!text) return otherwise;
    const auto value = whole_number<std::uint64_t>(text.value());
    if (!value)
      fail(file_, "in the OME-XML " + attribute + " is " + shown(text.value()),
           "export the file again");
    return *value;
  }

 private:
  void parse(const std::string& text) {
    if (!document_.load_buffer(text.data(), text.size()) || local_name(root()) != "OME")
      fail(file_, "the OME-XML is damaged", "export the file again");
  }

  std::set<std::string> names_of_files() const {
    std::set<std::string> names;
    for (const auto& image : children(root(), "Image"))
      for (const auto& data : children(child(image, "Pixels"), "TiffData"))
        if (const auto name = child(data, "UUID").attribute("FileName")) names.insert(name.value());
    return names;
  }

  std::filesystem::path file_;
  pugi::xml_document document_;
  std::string uuid_;  // of this file
  mutable std::optional<std::set<std::string>> names_of_files_;
};

std::string order_of(const OmeXml& xml, const pugi::xml_node& pixels) {
  const std::string order = lower(pixels.attribute("DimensionOrder").value());
  std::string planes = order.substr(std::min<std::size_t>(2, order.size()));
  std::string sorted = planes;
  std::sort(sorted.begin(), sorted.end());
  if (order.rfind("xy", 0) != 0 || sorted != "ctz")
    fail(xml.file(), "in the OME-XML DimensionOrder is " + shown(order), "export the file again");
  return planes;
}

std::array<std::optional<double>, 3> spacing_mm(const pugi::xml_node& pixels,
                                                std::vector<std::string>& notes) {
  std::array<std::optional<double>, 3> spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string size = std::string("PhysicalSize") + "XYZ"[axis];
    const auto value = finite_number(pixels.attribute(size.c_str()).value());
    if (!value || *value <= 0) continue;
    const std::string unit = pixels.attribute((size + "Unit").c_str()).as_string("\u00b5m");
    if (const auto mm = millimetres_in(unit))
      spacing[axis] = *value * *mm;
    else
      notes.push_back(size + " is in " + shown(unit) + ", which is not a length");
  }
  return spacing;
}

// Modulo annotations may combine two axes in z.
void require_plain_slices(const OmeXml& xml) {
  struct Finder final : pugi::xml_tree_walker {
    bool is_found = false;
    bool for_each(pugi::xml_node& node) override {
      is_found = is_found || local_name(node) == "ModuloAlongZ";
      return !is_found;
    }
  } finder;
  xml.root().traverse(finder);
  if (finder.is_found)
    fail(xml.file(), "the slices hold a further axis (ModuloAlongZ)",
         "export one volume, e.g. with Fiji");
}

class Images {
 public:
  Images(const OmeXml& xml, std::uint64_t samples, const CountPages& count_pages)
      : xml_(xml), samples_(samples), count_pages_(count_pages) {}

  std::vector<Hyperstack> all() {
    require_plain_slices(xml_);
    std::vector<Hyperstack> images;
    for (const auto& image : children(xml_.root(), "Image")) images.push_back(hyperstack(image));
    if (images.empty())
      fail(xml_.file(), "the OME-XML describes no image", "export the file again");
    return images;
  }

 private:
  Hyperstack hyperstack(const pugi::xml_node& image) {
    const pugi::xml_node pixels = child(image, "Pixels");
    Hyperstack stack;
    stack.name = image.attribute("Name").as_string(image.attribute("ID").value());
    stack.plane_size = {xml_.count(pixels, "SizeX", 0), xml_.count(pixels, "SizeY", 0)};
    stack.slices.size = xml_.count(pixels, "SizeZ", 0);
    stack.channels.size = channels(pixels, stack.channel_names);
    stack.frames.size = xml_.count(pixels, "SizeT", 0);
    set_order(stack, order_of(xml_, pixels));
    constexpr std::uint64_t max_planes = std::uint64_t{1} << 32;
    if (planes(stack) == 0 || planes(stack) > max_planes)
      fail(xml_.file(),
           "the OME-XML describes an image of " + std::to_string(planes(stack)) + " planes",
           "export the file again");
    stack.spacing_mm = spacing_mm(pixels, stack.notes);
    numbers_.clear();
    for (const auto& data : children(pixels, "TiffData")) add_run(stack, data);
    if (stack.runs.empty()) add_run(stack, pugi::xml_node());
    return stack;
  }

  // Planes with several samples per pixel hold as many channels.
  std::uint64_t channels(const pugi::xml_node& pixels, std::vector<std::string>& names) {
    const auto described = children(pixels, "Channel");
    for (const auto& channel : described) names.emplace_back(channel.attribute("Name").value());
    if (std::all_of(names.begin(), names.end(),
                    [](const std::string& name) { return name.empty(); }))
      names.clear();
    const pugi::xml_node first = described.empty() ? pugi::xml_node() : described.front();
    const std::uint64_t samples = xml_.count(first, "SamplesPerPixel", samples_);
    const std::uint64_t channels = xml_.count(pixels, "SizeC", 0);
    return samples > 1 && channels % samples == 0 ? channels / samples : channels;
  }

  // A missing element, or one without attributes, means all pages.
  void add_run(Hyperstack& stack, const pugi::xml_node& data) {
    PageRun run;
    const std::filesystem::path file = xml_.file_of(data);
    const auto [number, is_new] =
        numbers_.emplace(file, static_cast<std::uint32_t>(stack.files.size()));
    if (is_new) stack.files.push_back(file);
    run.file = number->second;
    run.first_page = xml_.count(data, "IFD", 0);
    for (const auto& [name, axis] : {std::pair("FirstZ", stack.slices),
                                     {"FirstC", stack.channels},
                                     {"FirstT", stack.frames}}) {
      const std::uint64_t first = xml_.count(data, name, 0);
      if (first >= axis.size)
        fail(xml_.file(),
             std::string("in the OME-XML ") + name + " is " + std::to_string(first) +
                 ", after the last",
             "export the file again");
      run.first_plane += first * axis.step;
    }
    const std::uint64_t pages = number_of_pages(file);
    const std::uint64_t left = planes(stack) - run.first_plane;
    const bool is_one = static_cast<bool>(data.attribute("IFD"));
    run.count = xml_.count(data, "PlaneCount",
                           xml_.count(data, "NumPlanes", is_one ? 1 : std::min(pages, left)));
    if (run.count > left || run.first_page > pages || run.count > pages - run.first_page)
      fail(xml_.file(),
           "the OME-XML describes " + std::to_string(run.count) + " planes from page " +
               std::to_string(run.first_page) + " on, and " + shown(file.filename().string()) +
               " has " + std::to_string(pages) + " pages",
           copy_or_export);
    if (run.count > 0) stack.runs.push_back(run);
  }

  std::uint64_t number_of_pages(const std::filesystem::path& file) {
    const auto counted = pages_.find(file);
    if (counted != pages_.end()) return counted->second;
    return pages_[file] = count_pages_(file);
  }

  const OmeXml& xml_;
  std::uint64_t samples_;
  const CountPages& count_pages_;
  std::map<std::filesystem::path, std::uint64_t> pages_;
  std::map<std::filesystem::path, std::uint32_t> numbers_;  // index of each file of an image
};

}  // namespace

std::vector<Hyperstack> ome_images(const std::filesystem::path& file,
                                   const std::string& description, std::uint64_t samples,
                                   const CountPages& count_pages) {
  const OmeXml xml(file, description);
  return Images(xml, samples, count_pages).all();
}
#else
std::vector<Hyperstack> ome_images(const std::filesystem::path& file, const std::string&,
                                   std::uint64_t, const CountPages&) {
  fail(file, "this is OME-TIFF, and discmc was built without pugixml",
       "install libpugixml-dev and build again");
}
#endif

}  // namespace discmc::command
