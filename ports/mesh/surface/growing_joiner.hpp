// A joiner with a host's memory: as much as the loose fragments need.
#ifndef DISCMC_MESH_SURFACE_GROWING_JOINER_HPP
#define DISCMC_MESH_SURFACE_GROWING_JOINER_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include <discmc/joiner.hpp>

namespace discmc::meshing {

/// A sink before another: takes the events of scans and makes regions of the loose fragments
/// among them. What finds no partner reaches the sink loose. A joiner that runs short of memory
/// passes on what it holds; then the next one, with four times as much, continues.
class GrowingJoiner {
 public:
  static constexpr std::size_t first_bytes = std::size_t{1} << 20;

  /// What takes the place of a joiner that is too large: the sink that gets what would go to it.
  struct Limit {
    std::uint64_t bytes;  ///< of all joiners
    Sink beyond;
  };

  /// sink: must take everything at once; Owner: the caller, as long as events are taken. order: as
  /// of the Joiner. bytes: of the first joiner.
  explicit GrowingJoiner(const Sink& sink, InputOrder order = InputOrder::sweep,
                         std::size_t bytes = first_bytes, std::optional<Limit> limit = {});
  GrowingJoiner(const GrowingJoiner&) = delete;
  GrowingJoiner& operator=(const GrowingJoiner&) = delete;

  SinkResult accept(const Event& event);

  /// Ends the events: a stream may break off before its `finish`.
  void finish();

  /// Whether a loose fragment has come. Before, every region is whole.
  bool has_fragments() const { return has_fragments_; }

  /// The totals of the `finish` event that the sink got; before it, zeroes.
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
  std::uint64_t unmatched_ = 0;  // fragments that came out so
  std::unique_ptr<GrowingJoiner> next_;
  bool is_beyond_limit_ = false;
};

}  // namespace discmc::meshing

#endif
