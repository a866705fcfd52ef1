#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "discmc/mesh.hpp"
#include "finished_mesh.hpp"
#include "owned_state.hpp"
#include "samples/spacing.hpp"
#include "streams/sent_fractions.hpp"
#include "streams/stream_reader.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::meshing {

// One scan of a link.
class ReceivedScan {
 public:
  explicit ReceivedScan(std::uint8_t channel) : reader_(make_sink(*this), {channel, {}}) {}
  ReceivedScan(const ReceivedScan&) = delete;
  ReceivedScan& operator=(const ReceivedScan&) = delete;

  SinkResult accept(const Event& event) {
    Placement placement;
    if (event.kind == Event::Kind::application && read_placement(*event.application, placement))
      placement_ = in_millimetres(placement);
    fractions_.accept(event);
    return surface_.accept(event);
  }

  void push(const std::uint8_t* bytes, std::size_t count) {
    reader_.push(bytes, count);
    if (reader_.report().has_trailer) surface_.finish();
  }
  void finish() {
    reader_.finish();
    surface_.finish();
  }

  const StreamReader& reader() const { return reader_; }
  const std::optional<VolumePlacement>& placement() const { return placement_; }
  JoinedSurface& surface() { return surface_; }
  const SentFractions& fractions() const { return fractions_; }

 private:
  JoinedSurface surface_;
  SentFractions fractions_;
  std::optional<VolumePlacement> placement_;
  StreamReader reader_;
};

}  // namespace discmc::meshing

namespace discmc {

using namespace meshing;

namespace {

std::array<std::array<double, 4>, 3> matrix_of(const VolumePlacement& placement) {
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis) rows[row][axis] = placement.axes_mm[axis][row];
    rows[row][3] = placement.origin_mm[row];
  }
  return rows;
}

}  // namespace

class MeshReceiver::State {
 public:
  explicit State(std::uint8_t channel) : channel_(channel) { begin(); }

  // A stream ends with a frame, which ends with a zero byte.
  std::size_t push(const std::uint8_t* bytes, std::size_t count) {
    if (has_ended_ && count > 0) begin();
    std::size_t consumed = 0;
    while (consumed < count && !has_ended_) {
      const std::uint8_t* const zero = std::find(bytes + consumed, bytes + count, 0);
      const auto end = static_cast<std::size_t>(zero - bytes) + (zero == bytes + count ? 0 : 1);
      scan_->push(bytes + consumed, end - consumed);
      consumed = end;
      has_ended_ = scan_->reader().report().has_trailer;
    }
    return consumed;
  }
  void finish() {
    if (!has_ended_) scan_->finish();
    has_ended_ = true;
  }

  bool has_ended() const { return has_ended_; }
  const StreamReader& reader() const { return scan_->reader(); }
  SurfaceBuilder& builder() const { return scan_->surface().builder(); }

  StreamReport report() const {
    StreamReport report = reader().report();
    report.lost_pieces += builder().incomplete_regions();
    return report;
  }

  Mesh mesh(MeshOptions options) const {
    if (!options.placement && scan_->placement() && is_usable(*scan_->placement()))
      options.placement = matrix_of(*scan_->placement());
    options.spacing = spacing_mm(reader().header());
    check_options(options);
    options.border = reader().header().border;
    if (options.smoothing > 0 || options.normals == Normals::gradient)
      throw std::invalid_argument(
          "a stream holds no samples: ask for relaxation in place of smoothing, and for surface "
          "normals");
    if (options.interpolates && !scan_->fractions().are_sent())
      throw std::invalid_argument(
          "this stream holds no fractions to interpolate: ask for relaxation, or send them by "
          "FractionSliceEncoder");
    Surface so_far = builder().surface();  // a copy, because the options set its spacing
    std::optional<Crossings> crossings;
    if (options.interpolates || options.relaxes) {
      crossings.emplace(reader().dims(), so_far.polygons);
      scan_->fractions().place(*crossings);
    }
    return finished_mesh(so_far, crossings ? &*crossings : nullptr, options, sweep_axes(options),
                         0);
  }

 private:
  void begin() {
    scan_ = std::make_unique<ReceivedScan>(channel_);
    has_ended_ = false;
  }

  std::uint8_t channel_;
  std::unique_ptr<ReceivedScan> scan_;
  bool has_ended_ = false;
};

namespace {

constexpr char no_receiver[] = "the receiver was moved from; construct another";

std::uint8_t checked(std::optional<std::uint8_t> channel) {
  if (channel && *channel > StreamLabel::max_channel)
    throw std::invalid_argument("the channel is " + std::to_string(*channel) + "; give 0 to " +
                                std::to_string(StreamLabel::max_channel));
  return channel.value_or(any_channel);
}

}  // namespace

MeshReceiver::MeshReceiver(std::optional<std::uint8_t> channel)
    : state_(std::make_unique<State>(checked(channel))) {}
MeshReceiver::~MeshReceiver() = default;
MeshReceiver::MeshReceiver(MeshReceiver&&) noexcept = default;
MeshReceiver& MeshReceiver::operator=(MeshReceiver&&) noexcept = default;

std::size_t MeshReceiver::push(const std::uint8_t* bytes, std::size_t count) {
  return require_state(state_, no_receiver).push(bytes, count);
}
void MeshReceiver::finish() {
  require_state(state_, no_receiver).finish();
}
bool MeshReceiver::has_ended() const {
  return require_state(state_, no_receiver).has_ended();
}
StreamReport MeshReceiver::report() const {
  return require_state(state_, no_receiver).report();
}
const StreamHeader& MeshReceiver::header() const {
  return require_state(state_, no_receiver).reader().header();
}
Mesh MeshReceiver::mesh(MeshOptions options) const {
  return require_state(state_, no_receiver).mesh(std::move(options));
}
std::size_t MeshReceiver::polygon_count() const {
  return require_state(state_, no_receiver).builder().surface().polygons.size();
}

}  // namespace discmc
