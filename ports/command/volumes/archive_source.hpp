// Unpacks archives with libarchive. Compiled only if libarchive is available.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "byte_source.hpp"

struct archive;

namespace discmc::command {

/// An archive as a source of bytes. Members are read one after another; read() reads the current
/// one.
class ArchiveSource final : public PartwiseSource {
 public:
  /// Registers the formats and filters with libarchive.
  using Support = void (*)(archive*);

  /// Reads the archive from another source, in one pass.
  ArchiveSource(std::unique_ptr<ByteSource> in, Support support);
  /// Reads a file in any order, because a zip has its list of members at the end.
  ArchiveSource(const std::filesystem::path& file, Support support);

  /// Begins the next file and returns its name; nothing at the end or at damage().
  std::optional<std::string> next_member();

  std::uint64_t max_left() const override { return unbounded; }
  void check_end() override;
  std::string damage() const override { return damage_; }

 private:
  explicit ArchiveSource(Support support);
  bool next_part() override;
  void note_damage();

  std::unique_ptr<ByteSource> in_;
  std::array<char, 65536> packed_{};
  std::unique_ptr<archive, int (*)(archive*)> archive_;
  bool is_at_end_ = false;  // of the current member
  std::size_t members_ = 0;
  std::string damage_;
};

}  // namespace discmc::command
