#include "hyperstack.hpp"

#include <algorithm>
#include <limits>

#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

constexpr std::uint64_t max_number = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > max_number / a ? max_number : a * b;
}

PlaneAxis* axis_called(Hyperstack& stack, char letter) {
  return letter == 'z'   ? &stack.slices
         : letter == 'c' ? &stack.channels
         : letter == 't' ? &stack.frames
                         : nullptr;
}

std::string range(std::uint64_t first, std::uint64_t count) {
  const std::string begin = std::to_string(first);
  return count == 1 ? begin : begin + " to " + std::to_string(first + count - 1);
}

// Lists the first stacks, such as "0 to 2 'left', 3 'right'".
std::string list_of(const std::vector<Hyperstack>& stacks) {
  constexpr std::size_t max_listed = 6;
  std::string list;
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < stacks.size() && i < max_listed; ++i) {
    list +=
        (i == 0 ? "" : ", ") + range(first, stacks[i].frames.size) + ' ' + shown(stacks[i].name);
    first += stacks[i].frames.size;
  }
  return list + (stacks.size() > max_listed ? ", ..." : "");
}

std::string description_of(const std::vector<Hyperstack>& stacks) {
  if (stacks.size() > 1) return " (" + list_of(stacks) + ")";
  return stacks[0].slices.size == 1 ? " of one slice each" : "";
}

}  // namespace

void set_order(Hyperstack& stack, std::string_view order) {
  std::uint64_t step = 1;
  for (const char letter : order) {
    PlaneAxis* const axis = axis_called(stack, letter);
    if (axis == nullptr) continue;
    axis->step = step;
    step = product(step, axis->size);
  }
}

void set_axis(Hyperstack& stack, char axis) {
  const std::uint64_t plane_count = planes(stack);
  stack.slices = stack.channels = stack.frames = {};
  axis_called(stack, axis)->size = plane_count;
  stack.channel_names.clear();
}

std::uint64_t planes(const Hyperstack& stack) {
  return product(product(stack.slices.size, stack.channels.size), stack.frames.size);
}

ChosenFrame chosen_frame(const std::filesystem::path& file, const std::vector<Hyperstack>& stacks,
                         std::optional<std::uint32_t> frame) {
  std::uint64_t frames = 0;
  for (const Hyperstack& stack : stacks) frames += stack.frames.size;
  if (frames > 1 && !frame)
    fail(file,
         "the file holds " + std::to_string(frames) + " volumes" + description_of(stacks) +
             ", and one is read at a time",
         std::string("choose one with --frame N, the first is 0") +
             (stacks.size() == 1 && stacks[0].slices.size == 1 ? if_slices : ""));
  std::uint64_t left = frame.value_or(0);
  for (const Hyperstack& stack : stacks) {
    if (left < stack.frames.size) return {&stack, left, frames};
    left -= stack.frames.size;
  }
  fail(file,
       "there is no volume " + std::to_string(frame.value_or(0)) + ": the file holds " +
           std::to_string(frames),
       frames > 1 ? "choose one with --frame 0 to " + std::to_string(frames - 1)
                  : "leave out --frame");
}

std::vector<Page> pages_of(const std::filesystem::path& file, const Hyperstack& stack,
                           std::uint64_t channel, std::uint64_t frame) {
  if (stack.slices.size == 0) fail(file, "the description has no slices", "export the file again");
  std::vector<PageRun> runs = stack.runs;
  std::sort(runs.begin(), runs.end(),
            [](const PageRun& a, const PageRun& b) { return a.first_plane < b.first_plane; });
  for (std::size_t i = 1; i < runs.size(); ++i)
    if (runs[i].first_plane - runs[i - 1].first_plane < runs[i - 1].count)
      fail(file,
           "plane " + std::to_string(runs[i].first_plane) + " has two pages in the description",
           "export the file again");
  std::vector<Page> pages;
  for (std::uint64_t slice = 0; slice < stack.slices.size; ++slice) {
    const std::uint64_t plane =
        slice * stack.slices.step + channel * stack.channels.step + frame * stack.frames.step;
    const auto behind =
        std::upper_bound(runs.begin(), runs.end(), plane,
                         [](std::uint64_t at, const PageRun& run) { return at < run.first_plane; });
    const auto run = behind == runs.begin() ? runs.end() : behind - 1;
    if (run == runs.end() || plane - run->first_plane >= run->count)
      fail(file,
           "slice " + std::to_string(slice) + " of channel " + std::to_string(channel) +
               " has no page in the file",
           "export the file again");
    pages.push_back(
        {run->file, static_cast<std::uint32_t>(run->first_page + plane - run->first_plane)});
  }
  return pages;
}

}  // namespace discmc::command
