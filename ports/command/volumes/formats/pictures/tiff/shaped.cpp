#include "descriptions.hpp"

#include <algorithm>
#include <utility>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/volume_error.hpp"

#ifdef DISCMC_WITH_JSON
#include <nlohmann/json.hpp>
#endif

namespace discmc::command {
namespace {

// Parses "shape=(20, 24, 30)", from versions before 2016.
std::optional<ShapedArray> without_json(std::string_view description) {
  constexpr std::string_view begin = "shape=(";
  if (description.rfind(begin, 0) != 0) return std::nullopt;
  description.remove_prefix(begin.size());
  std::string list(description.substr(0, description.find(')')));
  std::replace(list.begin(), list.end(), ',', ' ');
  ShapedArray array;
  for (const auto word : words(list)) {
    const auto size = whole_number<std::uint64_t>(word);
    if (!size) return std::nullopt;
    array.sizes.push_back(*size);
  }
  return array;
}

// The axes before the page's own. Without a Z axis, slices are the last axis that is unnamed or
// named I or Q.
class LeadingAxes {
 public:
  LeadingAxes(const ShapedArray& array, std::size_t count) {
    const bool is_named = array.axes.size() == array.sizes.size();
    for (std::size_t i = count; i-- > 0;)
      axes_.emplace_back(is_named ? array.axes[i] : 'Q', array.sizes[i]);
    const bool has_slices =
        std::any_of(axes_.begin(), axes_.end(), [](const auto& axis) { return axis.first == 'Z'; });
    const auto unnamed = std::find_if(axes_.begin(), axes_.end(), [](const auto& axis) {
      return axis.first == 'I' || axis.first == 'Q';
    });
    if (!has_slices && unnamed != axes_.end()) unnamed->first = 'Z';
  }

  // Returns nothing if other axes separate the axes of frames.
  std::optional<Hyperstack> planes() const {
    Hyperstack stack;
    std::uint64_t step = 1;
    for (const auto& [letter, size] : axes_) {
      PlaneAxis& axis = letter == 'Z'   ? stack.slices
                        : letter == 'C' ? stack.channels
                                        : stack.frames;
      if (axis.size == 1) axis.step = step;
      if (size > 1 && axis.step * axis.size != step) return std::nullopt;
      if (size == 0 || step > (std::uint64_t{1} << 32) / size) return std::nullopt;
      axis.size *= size;
      step *= size;
    }
    return stack;
  }

 private:
  std::vector<std::pair<char, std::uint64_t>> axes_;  // the fastest first
};

}  // namespace

#ifdef DISCMC_WITH_JSON
std::optional<ShapedArray> shaped_array(const std::filesystem::path&,
                                        const std::string& description) {
  if (description.rfind('{', 0) != 0) return without_json(description);
  const auto json = nlohmann::json::parse(description, nullptr, false);
  if (!json.is_object() || !json.contains("shape") || !json["shape"].is_array())
    return std::nullopt;
  ShapedArray array;
  for (const auto& size : json["shape"]) {
    if (!size.is_number_unsigned()) return std::nullopt;
    array.sizes.push_back(size.get<std::uint64_t>());
  }
  const auto text = [&json](const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                       : std::string();
  };
  array.axes = text("axes");
  array.name = text("name");
  return array;
}
#else
std::optional<ShapedArray> shaped_array(const std::filesystem::path& file,
                                        const std::string& description) {
  if (description.rfind("{\"shape\"", 0) == 0)
    fail(file, "tifffile wrote the description, and discmc was built without nlohmann-json",
         "install nlohmann-json3-dev and build again");
  return without_json(description);
}
#endif

std::optional<Hyperstack> planes_of(const ShapedArray& array,
                                    const std::vector<std::uint64_t>& page) {
  std::vector<std::uint64_t> sizes = array.sizes;
  // The array of grey pages may have an axis of size 1 for samples.
  if (page.size() == 2 && sizes.size() > 2 && sizes.back() == 1) sizes.pop_back();
  if (sizes.size() < page.size() || !std::equal(page.rbegin(), page.rend(), sizes.rbegin()))
    return std::nullopt;
  auto stack = LeadingAxes(array, sizes.size() - page.size()).planes();
  if (stack) stack->name = array.name;
  return stack;
}

}  // namespace discmc::command
