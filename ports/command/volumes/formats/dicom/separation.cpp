#include "stack.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "image.hpp"

namespace discmc::command {
namespace {

// A frame, and the number of its position among all positions.
struct Placed {
  const DicomFrame* frame = nullptr;
  std::size_t place = 0;
};
using Group = std::vector<Placed>;

Group placed(const std::vector<DicomFrame>& frames) {
  constexpr double same_mm = 1e-3;
  const Vector normal = normal_of(*frames[0].place);
  const auto along = [&](const Placed& each) { return dot(each.frame->place->position, normal); };
  Group group;
  for (const DicomFrame& frame : frames) group.push_back({&frame});
  std::stable_sort(group.begin(), group.end(),
                   [&](const Placed& a, const Placed& b) { return along(a) < along(b); });
  for (std::size_t i = 1; i < group.size(); ++i)
    group[i].place = group[i - 1].place + (along(group[i]) - along(group[i - 1]) > same_mm);
  return group;
}

void drop_copies(Group& group) {
  std::set<std::pair<std::string, std::uint32_t>> found;
  const auto is_copy = [&](const Placed& each) {
    const std::string& instance = each.frame->image->instance;
    return !instance.empty() && !found.emplace(instance, each.frame->number).second;
  };
  group.erase(std::remove_if(group.begin(), group.end(), is_copy), group.end());
}

// Returns the number of slices at each position that has any.
std::vector<std::size_t> counts_of_places(const Group& group) {
  std::map<std::size_t, std::size_t> counts;
  for (const Placed& each : group) ++counts[each.place];
  std::vector<std::size_t> result;
  result.reserve(counts.size());
  for (const auto& [place, count] : counts) result.push_back(count);
  return result;
}

std::size_t max_in_a_place(const Group& group) {
  const auto counts = counts_of_places(group);
  return *std::max_element(counts.begin(), counts.end());
}

struct TraitOrder {
  bool operator()(const std::string& a, const std::string& b) const {
    return is_trait_before(a, b);
  }
};

// Returns the groups by a trait of volumes. Such a trait has no more values than there are slices
// at a position, and leaves fewer slices there. Traits of slices, such as their times, do not.
std::vector<Group> groups_of_trait(const Group& group, std::size_t max_slices, std::size_t kind) {
  std::map<std::string, Group, TraitOrder> groups;
  for (const Placed& each : group) {
    groups[trait_of(each.frame->traits, kind)].push_back(each);
    if (groups.size() > max_slices) return {};
  }
  if (groups.size() < 2) return {};
  std::vector<Group> result;
  for (auto& [value, of_value] : groups) {
    if (max_in_a_place(of_value) == max_slices) return {};
    result.push_back(std::move(of_value));
  }
  return result;
}

// Returns the groups by the order of a trait: the first slices of all positions form one group, and
// so on. Returns none if positions have different numbers of slices, or if two slices share a
// value.
std::vector<Group> groups_of_order(const Group& group, std::size_t kind) {
  std::map<std::size_t, std::map<std::string, Placed, TraitOrder>> places;
  for (const Placed& each : group) {
    const std::string& value = trait_of(each.frame->traits, kind);
    if (value.empty() || !places[each.place].emplace(value, each).second) return {};
  }
  std::vector<Group> groups(places.begin()->second.size());
  for (const auto& [place, slices] : places) {
    if (slices.size() != groups.size()) return {};
    auto target = groups.begin();
    for (const auto& [value, slice] : slices) (target++)->push_back(slice);
  }
  return groups;
}

SeparatedFrames frames_of(const Group& group, std::string order = {}) {
  SeparatedFrames result{{}, std::move(order)};
  for (const Placed& each : group) result.frames.push_back(*each.frame);
  return result;
}

void add_by_order(const Group& group, std::vector<SeparatedFrames>& parts) {
  for (std::size_t kind = 0; kind < trait_count(); ++kind) {
    if (!has_order(kind)) continue;
    const auto groups = groups_of_order(group, kind);
    for (std::size_t i = 0; i < groups.size(); ++i)
      parts.push_back(
          frames_of(groups[i], "number " + std::to_string(i + 1) + " by " + trait_name(kind)));
    if (!groups.empty()) return;
  }
  parts.push_back(frames_of(group));
}

void separate(const Group& group, std::vector<SeparatedFrames>& parts) {
  const std::size_t max_slices = max_in_a_place(group);
  if (max_slices == 1) {
    parts.push_back(frames_of(group));
    return;
  }
  for (std::size_t kind = 0; kind < trait_count(); ++kind) {
    const auto groups = groups_of_trait(group, max_slices, kind);
    for (const Group& each : groups) separate(each, parts);
    if (!groups.empty()) return;
  }
  add_by_order(group, parts);
}

}  // namespace

std::vector<SeparatedFrames> separated(const std::vector<DicomFrame>& frames) {
  Group group = placed(frames);
  if (max_in_a_place(group) == 1) return {{frames, {}}};
  drop_copies(group);
  std::vector<SeparatedFrames> parts;
  separate(group, parts);
  if (parts.size() == 1) return {{frames, {}}};
  return parts;
}

}  // namespace discmc::command
