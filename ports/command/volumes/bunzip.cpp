#include <utility>

#include "byte_source.hpp"

#ifdef DISCMC_WITH_BZIP2
#include <bzlib.h>

#include <algorithm>
#include <array>
#include <new>
#endif

namespace discmc::command {

#ifdef DISCMC_WITH_BZIP2
namespace {

class Bunzipper final : public ByteSource {
 public:
  explicit Bunzipper(std::unique_ptr<ByteSource> in) : in_(std::move(in)) { start(); }
  Bunzipper(const Bunzipper&) = delete;
  Bunzipper& operator=(const Bunzipper&) = delete;
  ~Bunzipper() override { BZ2_bzDecompressEnd(&state_); }

  std::size_t read(void* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && !ended_ && damage_.empty()) {
      refill();
      constexpr std::size_t max_at_once = 1U << 30;
      const auto room = static_cast<unsigned>(std::min(count - done, max_at_once));
      state_.next_out = static_cast<char*>(bytes) + done;
      state_.avail_out = room;
      const bool is_at_end = state_.avail_in == 0;
      const int status = BZ2_bzDecompress(&state_);
      done += room - state_.avail_out;
      if (status == BZ_STREAM_END)
        end_member();
      else if (status != BZ_OK)
        damage_ = "the compressed data is damaged";
      else if (is_at_end && state_.avail_out == room)
        damage_ = "the compressed data ends early";
    }
    return done;
  }

  // A few bytes can stand for many megabytes.
  std::uint64_t max_left() const override { return unbounded; }
  void check_end() override {
    unsigned char beyond = 0;
    read(&beyond, 1);
  }
  std::string damage() const override { return damage_; }

 private:
  void start() {
    if (BZ2_bzDecompressInit(&state_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  void refill() {
    if (state_.avail_in != 0) return;
    state_.next_in = input_.data();
    state_.avail_in = static_cast<unsigned>(in_->read(input_.data(), input_.size()));
  }

  // bzip2 files may be concatenated.
  void end_member() {
    refill();
    ended_ = state_.avail_in == 0;
    if (ended_) return;
    const bz_stream input = state_;
    BZ2_bzDecompressEnd(&state_);
    state_ = {};
    start();
    state_.next_in = input.next_in;
    state_.avail_in = input.avail_in;
  }

  std::unique_ptr<ByteSource> in_;
  bz_stream state_{};
  std::array<char, 65536> input_;
  std::string damage_;
  bool ended_ = false;
};

}  // namespace

bool has_bzip2() {
  return true;
}

std::unique_ptr<ByteSource> bunzipped(std::unique_ptr<ByteSource> in) {
  return std::make_unique<Bunzipper>(std::move(in));
}
#else
bool has_bzip2() {
  return false;
}

std::unique_ptr<ByteSource> bunzipped(std::unique_ptr<ByteSource> in) {
  return in;
}
#endif

}  // namespace discmc::command
