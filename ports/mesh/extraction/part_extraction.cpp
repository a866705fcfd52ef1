#include "part_extraction.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_set>
#include <utility>

#include <discmc/chain.hpp>

#include "array.hpp"
#include "encoded_part.hpp"
#include "event_record.hpp"
#include "extractors.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "mask_bits.hpp"
#include "surface/growing_joiner.hpp"

namespace discmc::meshing {
namespace {

// Collects what a part contributes to a surface: regions as polygons, as packets or as both, and
// pieces to join. Parts follow each other from below, so the pieces of a region arrive in the order
// of a sweep.
//
// If a fragment of its plane is sent before a hole, the hole is sent as a loose ring, although its
// region is whole. Then the region must be joined, too. Holes that cross a seam belong to regions
// that cross it: no hole lies entirely below or above the ring around it.
class PartSurface {
 public:
  explicit PartSurface(const SurfaceRequest& request) {
    if (request.builder != nullptr) polygons_.emplace(request.builder->kept());
    if (request.encoder != nullptr) packets_ = std::make_unique<EncodedPart>();
  }

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::finish) return SinkResult::accepted;  // the parts share one
    if (event.kind == Event::Kind::start && packets_) packets_->accept(event);
    if (event.kind == Event::Kind::region) {
      region_ = event;  // waits for its first ring
      return SinkResult::accepted;
    }
    if (event.kind == Event::Kind::ring && region_) begin_region(event.start);
    if (destination_ == Destination::joined) follow_fragment(event);
    const SinkResult answer = forward(event);
    if (event.kind == Event::Kind::region_end) destination_ = Destination::joined;
    return answer;
  }

  // Accepts a whole region.
  SinkResult accept_region(const OneRingRegion& region) {
    if (has_loose_rings(region.incidence(), region.start())) return SinkResult::busy;
    if (packets_) packets_->accept_region(region);
    if (polygons_) polygons_->accept_region(region);
    return SinkResult::accepted;
  }

  // Appends polygons to the request's builder and packets to its encoder. Sends the pieces to join
  // to the joiner, which has the request's sink.
  void deliver_to(const SurfaceRequest& request, GrowingJoiner& joiner) {
    if (polygons_) request.builder->append(std::move(*polygons_));
    joined_.replay(make_sink(joiner));
    if (packets_) packets_->append_to(*request.encoder);
  }

 private:
  enum class Destination { whole, joined };

  static std::uint64_t plane_of(Incidence incidence, const Vertex& vertex) {
    return std::uint64_t{incidence} << 32 |
           static_cast<std::uint32_t>(plane_offset(incidence, vertex));
  }

  bool has_loose_rings(Incidence incidence, const Vertex& vertex) const {
    return !ring_planes_.empty() && ring_planes_.count(plane_of(incidence, vertex)) > 0;
  }

  void begin_region(const Vertex& vertex) {
    const Event region = *std::exchange(region_, std::nullopt);
    destination_ =
        has_loose_rings(region.incidence, vertex) ? Destination::joined : Destination::whole;
    forward(region);
  }

  // Records the planes of loose rings, which end where and in the direction in which they start.
  void follow_fragment(const Event& event) {
    if (event.kind == Event::Kind::fragment) {
      fragment_ = event;
      end_ = event.start;
    } else if (fragment_ && event.kind == Event::Kind::run) {
      last_direction_ = event.run.direction();
      translate(end_, fragment_->incidence, last_direction_, event.run.length());
    } else if (fragment_ && event.kind == Event::Kind::fragment_end) {
      if (end_ == fragment_->start && last_direction_ == fragment_->incoming_direction)
        ring_planes_.insert(plane_of(fragment_->incidence, end_));
      fragment_.reset();
    }
  }

  SinkResult forward(const Event& event) {
    if (destination_ == Destination::joined) return joined_.accept(event);
    if (polygons_) polygons_->accept(event);
    if (packets_) packets_->accept(event);
    return SinkResult::accepted;
  }

  std::optional<Event> region_;
  Destination destination_ = Destination::joined;  // of the current events
  std::optional<Event> fragment_;                  // the current one
  Vertex end_{};                                   // of the current fragment
  Direction last_direction_ = 0;                   // direction in which it reached end_
  std::unordered_set<std::uint64_t> ring_planes_;
  // The whole regions, in the requested forms.
  std::optional<SurfaceBuilder> polygons_;
  std::unique_ptr<EncodedPart> packets_;
  EventRecord joined_;
};

struct Part {
  // Return a slice that was read; null without a mask.
  const std::uint8_t* samples_of(std::uint32_t z) const { return slice_of(samples, z); }
  const std::uint8_t* mask_of(std::uint32_t z) const {
    return mask.empty() ? nullptr : slice_of(mask, z);
  }

  SlabSpans spans;
  Array<std::uint8_t> samples;  // of the slices read
  Array<std::uint8_t> mask;     // rows of bits, if there is a mask
  std::vector<PartSurface> surfaces;
  std::vector<Extraction> extractions;

 private:
  const std::uint8_t* slice_of(const Array<std::uint8_t>& slices, std::uint32_t z) const {
    return slices.data() + slices.size() / spans.read.count() * (z - spans.read.first);
  }
};

// Reads slices of equal size once, for overlapping spans.
class OverlappingSlices {
 public:
  explicit OverlappingSlices(std::size_t slice_bytes) : slice_bytes_(slice_bytes) {}

  // read(bytes): reads the next slice. Limit: spans are in order, and only the first may follow a
  // gap.
  template <class Read>
  void fill(const SliceSpan& span, Array<std::uint8_t>& slices, Read read) {
    const std::size_t shared = end_ > span.first ? (end_ - span.first) * slice_bytes_ : 0;
    slices.resize(span.count() * slice_bytes_);
    std::copy(kept_slices_.end() - shared, kept_slices_.end(), slices.begin());
    for (std::size_t at = shared; at < slices.size(); at += slice_bytes_) read(&slices[at]);
    const std::size_t kept = std::min<std::size_t>(max_shared, span.count()) * slice_bytes_;
    kept_slices_.resize(0);
    kept_slices_.append(slices.end() - kept, kept);
    end_ = span.end;
  }

 private:
  // Two parts share slices: one of context and one for the filter on either side.
  static constexpr std::size_t max_shared = 4;

  std::size_t slice_bytes_;
  Array<std::uint8_t> kept_slices_;
  std::uint32_t end_ = 0;
};

// Reads parts one after another, and passes on each slice once.
class PartReader {
 public:
  PartReader(SliceReader& volume, const SurfaceOptions& options,
             const std::vector<SurfaceRequest>& surfaces)
      : volume_(volume),
        sample_slices_(volume.info().slice_bytes()),
        mask_slices_(0),
        slices_(options.slices) {
    for (const SurfaceRequest& surface : surfaces)
      if (surface.crossings != nullptr) crossings_.push_back(surface.crossings);
    if (options.mask == nullptr) return;
    mask_.emplace(*options.mask);
    const auto& dims = options.mask->info().dims;
    mask_bytes_ = bit_row_bytes(dims[0]) * dims[1];
    mask_slices_ = OverlappingSlices(mask_bytes_);
  }

  void read(Part& part) {
    const SliceSpan& span = part.spans.read;
    skip_to(span.first);
    sample_slices_.fill(span, part.samples,
                        [this](std::uint8_t* slice) { volume_.read_slice(slice); });
    if (mask_)
      mask_slices_.fill(span, part.mask, [this](std::uint8_t* slice) {
        std::memcpy(slice, mask_->next_slice(), mask_bytes_);
      });
    for (; end_ < span.end; ++end_) pass_on(part.samples_of(end_), part.mask_of(end_));
  }

 private:
  void pass_on(const std::uint8_t* samples, const std::uint8_t* mask_rows) const {
    if (slices_) slices_(samples, mask_rows);
    for (CrossingFinder* const each : crossings_) each->add_slice(samples, mask_rows);
  }
  void skip_to(std::uint32_t first) {
    for (; end_ < first; ++end_) {
      volume_.skip_slice();
      if (mask_) mask_->skip_slice();
    }
  }

  SliceReader& volume_;
  OverlappingSlices sample_slices_;
  std::optional<MaskBits> mask_;
  std::size_t mask_bytes_ = 0;
  OverlappingSlices mask_slices_;
  decltype(SurfaceOptions::slices) slices_;
  std::vector<CrossingFinder*> crossings_;
  std::uint32_t end_ = 0;  // end of the slices that were read or skipped
};

using PartExtractors = Extractors<HostExtractor>;

// Extractors that are free for the next part.
class IdleExtractors {
 public:
  std::unique_ptr<PartExtractors> acquire() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty()) return nullptr;
    std::unique_ptr<PartExtractors> extractors = std::move(idle_.back());
    idle_.pop_back();
    return extractors;
  }
  void release(std::unique_ptr<PartExtractors> extractors) {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(extractors));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<PartExtractors>> idle_;
};

class PartExtraction {
 public:
  PartExtraction(SliceReader& volume, const SurfaceOptions& options,
                 const std::vector<SurfaceRequest>& surfaces)
      : info_(volume.info()),
        options_(options),
        requests_(surfaces),
        progress_(std::exchange(options_.progress, nullptr)),
        reader_(volume, options, surfaces),
        spans_(parts_of(info_, slices_of(options.slab, info_.dims[2]))) {
    options_.slices = nullptr;  // the reader passes them on
    for (const SurfaceRequest& request : requests_)
      joiners_.push_back(std::make_unique<GrowingJoiner>(request.sink));
  }

  std::vector<Extraction> extract() {
    run_in_order<Part>(
        *options_.jobs, spans_.size(), [this](std::size_t i, Part& part) { read(i, part); },
        [this](std::size_t, Part& part) { extract(part); },
        [this](std::size_t, Part& part) { deliver(part); });
    for (std::size_t i = 0; i < requests_.size(); ++i) finish(*joiners_[i], sums_[i].statistics);
    return sums_;
  }

 private:
  void read(std::size_t number, Part& part) {
    const SliceSpan own = spans_[number];
    part.spans = slab_spans(own, info_.dims[2], options_.filters_by_majority);
    reader_.read(part);
  }

  void extract(Part& part) {
    std::unique_ptr<PartExtractors> extractors = idle_.acquire();
    if (!extractors)
      extractors = std::make_unique<PartExtractors>(arena_of<HostExtractor>(volume_limits()),
                                                    requests_.size());
    Limits limits = volume_limits();
    const SlabRange slab{part.spans.own.first, part.spans.own.count(), info_.dims[2]};
    limits.slab = slab_limits(slab, info_.dims[2]);
    std::vector<SurfaceRequest> requests = requests_;
    part.surfaces.clear();
    for (const SurfaceRequest& request : requests_) part.surfaces.emplace_back(request);
    for (std::size_t i = 0; i < requests.size(); ++i) {
      requests[i].sink = make_sink(part.surfaces[i]);
      requests[i].regions = make_region_receiver(part.surfaces[i]);
      requests[i].crossings = nullptr;  // the reader passes on the slices
    }
    std::uint32_t next = part.spans.read.first;
    part.extractions = extractors->extract(info_, limits, part.spans, options_, requests, [&] {
      const std::uint32_t z = next++;
      return SliceToExtract{part.samples_of(z), part.mask_of(z)};
    });
    idle_.release(std::move(extractors));
  }

  void deliver(Part& part) {
    for (std::size_t i = 0; i < requests_.size(); ++i)
      part.surfaces[i].deliver_to(requests_[i], *joiners_[i]);
    part.surfaces.clear();
    add(part.extractions);
    if (progress_) progress_(part.spans.own.end);
  }

  // totals: of the parts; then of the joined result.
  void finish(GrowingJoiner& joiner, Statistics& totals) const {
    Event event{};
    event.kind = Event::Kind::finish;
    event.slice = spans_.back().end - spans_.front().first;
    event.statistics = &totals;
    joiner.accept(event);
    joiner.finish();
    totals = joiner.totals();
  }

  // Two parts share the cells at their seam, and each rounds its counts down.
  static void add_left_triangles(Extraction& sum, std::uint32_t parts) {
    constexpr std::uint32_t whole = detail::trace::CountParts::triangle;
    sum.left_triangle_parts += parts;
    sum.statistics.classic_triangles += sum.left_triangle_parts / whole;
    sum.left_triangle_parts %= whole;
  }

  void add(const std::vector<Extraction>& extractions) {
    if (sums_.empty()) {
      sums_ = extractions;
      for (Extraction& sum : sums_) sum.is_of_slab = options_.slab.has_value();
      return;
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      discmc::add_totals(sums_[i].statistics, extractions[i].statistics);
      sums_[i].voxels += extractions[i].voxels;
      sums_[i].not_numbers += extractions[i].not_numbers;
      sums_[i].is_full = sums_[i].is_full && extractions[i].is_full;
      add_left_triangles(sums_[i], extractions[i].left_triangle_parts);
    }
  }

  Limits volume_limits() const { return {info_.dims[0], info_.dims[1], options_.border}; }

  SampleGrid info_;
  SurfaceOptions options_;
  const std::vector<SurfaceRequest>& requests_;
  std::function<void(std::uint32_t)> progress_;  // of all parts together
  PartReader reader_;
  std::vector<SliceSpan> spans_;
  IdleExtractors idle_;
  std::vector<std::unique_ptr<GrowingJoiner>> joiners_;
  std::vector<Extraction> sums_;
};

}  // namespace

std::vector<SliceSpan> parts_of(const SampleGrid& info, const SliceSpan& slices) {
  constexpr std::uint32_t min_thickness = 16, max_thickness = 32, min_parts = 8;
  constexpr std::uint64_t max_bytes = std::uint64_t{64} << 20;
  const std::uint32_t depth = slices.count();
  const auto max_slices = static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>(max_bytes / info.slice_bytes(), 2, max_thickness));
  const std::uint32_t thickness =
      std::min(std::clamp(depth / min_parts, min_thickness, max_thickness), max_slices);
  const std::uint32_t count = (depth + thickness - 1) / thickness;
  const auto end_of = [&](std::uint32_t part) {
    return slices.first + static_cast<std::uint32_t>(std::uint64_t{depth} * part / count);
  };
  std::vector<SliceSpan> spans;
  for (std::uint32_t part = 0; part < count; ++part)
    spans.push_back({end_of(part), end_of(part + 1)});
  return spans;
}

std::vector<Extraction> extract_in_parts(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces) {
  return PartExtraction(volume, options, surfaces).extract();
}

}  // namespace discmc::meshing
