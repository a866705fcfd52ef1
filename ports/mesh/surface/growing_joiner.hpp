// A joiner whose memory grows with the loose fragments.
#ifndef DISCMC_MESH_SURFACE_GROWING_JOINER_HPP
#define DISCMC_MESH_SURFACE_GROWING_JOINER_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include <discmc/joiner.hpp>

namespace discmc::meshing {

/// A sink before another sink. Accepts the events of scans, and makes regions of loose fragments.
/// Fragments without partners reach the other sink loose. A joiner that runs short of memory sends
/// all its chains to the next joiner, which has four times the memory.
class GrowingJoiner {
 public:
  static constexpr std::size_t first_bytes = std::size_t{1} << 20;

  /// The most memory, and the sink of all further events if joiners would need more.
  struct Limit {
    std::uint64_t bytes;  ///< of all joiners
    Sink beyond;
  };

  /// sink: accepts every event at once. Owner: the caller, as long as events come. order: as for
  /// Joiner. bytes: memory of the first joiner.
  explicit GrowingJoiner(const Sink& sink, InputOrder order = InputOrder::sweep,
                         std::size_t bytes = first_bytes, std::optional<Limit> limit = {});
  GrowingJoiner(const GrowingJoiner&) = delete;
  GrowingJoiner& operator=(const GrowingJoiner&) = delete;

  SinkResult accept(const Event& event);

  /// Ends the events, even if a stream broke off before its `finish`.
  void finish();

  /// Whether a loose fragment has arrived. Until then every region is whole.
  bool has_fragments() const { return has_fragments_; }

  /// Returns the totals of the `finish` event; zeroes before it.
  const Statistics& totals() const;

 private:
  SinkResult pass(const Event& event);
  bool update_unmatched();
  void grow();

  Sink sink_;
  InputOrder order_;
  std::size_t bytes_;
  std::optional<Limit> limit_;
  std::unique_ptr<std::uint8_t[]> memory_;
  Joiner joiner_;
  bool has_fragments_ = false;
  Statistics totals_{};
  std::uint64_t unmatched_ = 0;  // fragments that left without a partner
  std::unique_ptr<GrowingJoiner> next_;
  bool is_beyond_limit_ = false;
};

}  // namespace discmc::meshing

#endif
