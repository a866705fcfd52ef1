#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "byte_source.hpp"

namespace discmc::command {
namespace {

class Inflater final : public ByteSource {
 public:
  /// blocks: the number of streams, or 0 for gzip members, which mark their own end.
  Inflater(std::unique_ptr<ByteSource> in, std::uint64_t blocks)
      : in_(std::move(in)), blocks_(blocks) {
    constexpr int largest_window_either_wrapper = 15 + 32;
    if (inflateInit2(&state_, largest_window_either_wrapper) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() override { inflateEnd(&state_); }

  std::size_t read(void* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && !ended_ && damage_.empty()) {
      refill();
      constexpr std::size_t max_at_once = 1U << 30;
      const auto room = static_cast<uInt>(std::min(count - done, max_at_once));
      state_.next_out = static_cast<unsigned char*>(bytes) + done;
      state_.avail_out = room;
      const int status = inflate(&state_, Z_NO_FLUSH);
      done += room - state_.avail_out;
      if (status == Z_STREAM_END) {
        end_member();
      } else if (status == Z_BUF_ERROR) {
        damage_ = "the compressed data ends early";
      } else if (status != Z_OK) {
        damage_ = "the compressed data is damaged";
        if (state_.msg != nullptr) damage_ += std::string(" (") + state_.msg + ")";
      }
    }
    return done;
  }

  std::uint64_t max_left() const override {
    // Deflate cannot expand a byte of its stream to more than this.
    constexpr std::uint64_t max_inflation = 1032;
    const std::uint64_t packed = in_->max_left();
    if (packed >= unbounded / max_inflation - state_.avail_in) return unbounded;
    return (packed + state_.avail_in) * max_inflation;
  }

  void check_end() override {
    unsigned char beyond = 0;
    read(&beyond, 1);
  }

  std::string damage() const override { return damage_.empty() ? in_->damage() : damage_; }

 private:
  void refill() {
    if (state_.avail_in != 0) return;
    state_.next_in = input_.data();
    state_.avail_in = static_cast<uInt>(in_->read(input_.data(), input_.size()));
  }

  // gzip files may be concatenated; other bytes after the end are padding.
  void end_member() {
    if (blocks_ > 0) {
      ended_ = --blocks_ == 0 || inflateReset(&state_) != Z_OK;
      return;
    }
    refill();
    constexpr unsigned char gzip_magic = 0x1f;
    ended_ = state_.avail_in == 0 || *state_.next_in != gzip_magic || inflateReset(&state_) != Z_OK;
  }

  std::unique_ptr<ByteSource> in_;
  std::uint64_t blocks_;
  z_stream state_{};
  std::array<unsigned char, 65536> input_;
  std::string damage_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> inflated(std::unique_ptr<ByteSource> in) {
  return std::make_unique<Inflater>(std::move(in), 0);
}

std::unique_ptr<ByteSource> inflated_blocks(std::unique_ptr<ByteSource> in, std::uint64_t count) {
  return std::make_unique<Inflater>(std::move(in), count);
}

}  // namespace discmc::command
