// The fragments of compressed pixel data, and the frame that each belongs to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class DcmPixelItem;
class DcmPixelSequence;

namespace discmc::command {

/// Lists them once: DCMTK counts from the first fragment each time that one is asked for.
class DicomFragments {
 public:
  /// Owner of the sequence: the file, which stays open. frames: as the header counts.
  DicomFragments(DcmPixelSequence& sequence, std::uint32_t frames);

  /// Reads all fragments of a frame into bytes. Returns what is wrong, empty if nothing.
  std::string read(std::uint32_t frame, std::vector<std::uint8_t>& bytes);

  /// Frames beyond those that the header counts, if offsets are missing.
  std::size_t left_out() const { return left_out_; }

 private:
  void set_starts_by_table(std::uint32_t frames);
  void set_starts_by_jpeg(std::uint32_t frames);
  const std::uint8_t* content(std::size_t fragment);

  std::vector<DcmPixelItem*> items_;  ///< the first is the table of offsets
  std::vector<std::size_t> starts_;   ///< of frames, in items_, and the end; empty if unknown
  std::size_t left_out_ = 0;
};

}  // namespace discmc::command
