#include "unpacked_volume.hpp"

#include <string>
#include <utility>

#include "temporary_folder.hpp"

namespace discmc::command {
namespace {

using Open = std::function<std::unique_ptr<VolumeReader>(const std::filesystem::path& folder)>;

class UnpackedVolume final : public VolumeReader {
 public:
  UnpackedVolume(std::filesystem::path packed, std::string_view packing, const Open& open)
      : packed_(std::move(packed)) {
    renamed([&] { volume_ = open(folder_.path()); });
    info_ = volume_->info();
    info_.format += ", " + std::string(packing);
  }

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override {
    renamed([&] { volume_->read_slice(samples); });
  }
  void skip_slice() override {
    renamed([&] { volume_->skip_slice(); });
  }

 private:
  template <class Call>
  void renamed(Call call) {
    try {
      call();
    } catch (const VolumeError& error) {
      std::string text = error.what();
      const std::string folder = folder_.path().string(), packed = packed_.string();
      for (std::size_t at = text.find(folder); at != std::string::npos;
           at = text.find(folder, at + packed.size()))
        text.replace(at, folder.size(), packed);
      throw VolumeError(text);
    }
  }

  std::filesystem::path packed_;
  TemporaryFolder folder_;
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
};

}  // namespace

std::unique_ptr<VolumeReader> unpacked_volume(const std::filesystem::path& packed,
                                              std::string_view packing, const Open& open) {
  return std::make_unique<UnpackedVolume>(packed, packing, open);
}

}  // namespace discmc::command
