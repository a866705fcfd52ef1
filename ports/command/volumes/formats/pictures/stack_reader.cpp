// A stack of pictures as a volume: one picture per slice in the order of names, or pages in the
// order that the file describes.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "picture_file.hpp"
#include "picture_names.hpp"
#include "stack.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

using Files = std::vector<std::filesystem::path>;

// Throws unless all files are of one kind.
void require_one_kind(const std::filesystem::path& source, const Files& files) {
  std::map<PictureKind, Files> kinds;
  for (const auto& file : files) kinds[kind_of_name(file)].push_back(file);
  if (kinds.size() < 2) return;
  std::string list;
  const Files* largest_kind = nullptr;
  for (const auto& [kind, files_of_kind] : kinds) {
    list += (list.empty() ? "" : " and ") + std::to_string(files_of_kind.size()) + ' ' +
            std::string(name(kind));
    if (largest_kind == nullptr || files_of_kind.size() > largest_kind->size())
      largest_kind = &files_of_kind;
  }
  const std::filesystem::path pattern = "*" + largest_kind->front().extension().string();
  fail(source, list + " files are not one volume",
       "give a pattern of one kind, such as '" +
           (largest_kind->front().parent_path() / pattern).string() + "'");
}

// Omits SkyScan's overviews, which are beside the slices.
void leave_out_overviews(Files& files, VolumeInfo& info) {
  const auto overviews = std::stable_partition(
      files.begin(), files.end(), [](const auto& file) { return !is_overview_name(file); });
  if (overviews == files.begin()) return;
  for (auto file = overviews; file != files.end(); ++file)
    note(info, shown(file->filename().string()) + " is an overview, and is left out");
  files.erase(overviews, files.end());
}

// Treats missing names as missing slices, if each file is a slice.
void close_gaps(const std::filesystem::path& source, bool allow_gaps, Stack& stack,
                VolumeInfo& info) {
  if (stack.files.size() != stack.pages.size() || stack.described.files.size() > 1) return;
  const std::vector<Gap> gaps = gaps_of_names(stack.files);
  if (gaps.empty()) return;
  note(info,
       note_of_filling(source, gaps, stack.pages.size(), allow_gaps,
                       "export or copy the pictures again, or number their names without gaps"));
  fill_gaps(stack.pages, gaps);
}

class PictureStack final : public NumberedSlices {
 public:
  PictureStack(const std::filesystem::path& source, VolumeInfo info, Stack stack)
      : NumberedSlices(source, std::move(info)), stack_(std::move(stack)) {}

 private:
  void read(std::uint32_t slice, void* samples) override {
    const Page page = stack_.pages[slice];
    if (!opened_ || page.file != opened_file_) opened_ = open_picture(stack_.files[page.file]);
    opened_file_ = page.file;
    const PictureHeader header = opened_->header(page.number);
    if (header.width != info().dims[0] || header.height != info().dims[1] ||
        header.type != info().type || header.channels != stack_.header.channels)
      fail(stack_.files[page.file], "the file changed during reading",
           "read it again when it no longer changes");
    opened_->read(page.number, stack_.channel, static_cast<unsigned char*>(samples));
  }

  Stack stack_;
  std::unique_ptr<PictureFile> opened_;
  std::uint32_t opened_file_ = 0;
};

}  // namespace

std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source, Files files,
                                            const VolumeOptions& options) {
  VolumeInfo info;
  leave_out_overviews(files, info);
  require_one_kind(source, files);
  sort_naturally(files);
  if (sort_by_decimals(files))
    note(info, "the decimal or signed numbers in the names give the order, and no distance");
  else
    require_one_stack(source, files);
  Stack stack = stack_of(source, files, options, info);
  close_gaps(source, options.allow_gaps, stack, info);
  info.type = stack.header.type;
  const std::uint64_t frames = info.frames;
  set_dims(
      info, source,
      {stack.header.width, stack.header.height, static_cast<std::int64_t>(stack.pages.size())});
  info.frames = frames;
  if (stack.pages.size() == 1)
    note(info,
         "this is one slice; for a whole stack, give its folder, or a pattern, such as '" +
             (stack.files[0].parent_path() / ("*" + stack.files[0].extension().string())).string() +
             "'");
  set_place_of(info, stack, options);
  set_scale(info, source, stack.described.slope, stack.described.intercept);
  if (stack.header.is_inverted) note(info, "low values are bright; the values are used as stored");
  if (!stack.header.palette.empty())
    note(info, "the samples are numbers of colours in a palette, and are used as stored");
  info.format = name(kind_of(stack.files[0]));
  return std::make_unique<PictureStack>(source, std::move(info), std::move(stack));
}

}  // namespace discmc::command
