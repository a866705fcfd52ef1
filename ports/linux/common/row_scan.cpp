#include "row_scan.hpp"

#include <algorithm>
#include <stdexcept>

#include "extraction/arena_memory.hpp"
#include "require.hpp"
#include "samples/spacing.hpp"

namespace discmc::device {

using meshing::require;

namespace {

StreamLabel label_of(const ScanPlan& plan) {
  const auto spacing = meshing::spacing_nm(plan.spacing_mm);
  return {plan.dims[2], {spacing[0], spacing[1], spacing[2]}};
}

}  // namespace

RowScan::RowScan(const ScanPlan& plan, const ByteOutput& output)
    : plan_(plan), memory_(plan.memory) {
  const Limits limits{plan.dims[0], plan.dims[1], plan.border};
  if (command::fits_narrow_indices(limits, memory_.size()))
    extractor_.emplace<Extractor16>();
  else
    extractor_.emplace<Extractor32>();
  require(encoder_.start(label_of(plan), output));
  const Status started = std::visit(
      [&](auto& extractor) {
        return extractor.start(limits, plan.threshold, {memory_.data(), memory_.size()},
                               make_sink(encoder_));
      },
      extractor_);
  if (started == Status::too_little_memory)
    throw std::invalid_argument(
        command::too_little_memory(memory_.size(), limits, Extractor16::minimum_bytes(limits)));
  require(started);
}

template <class Sample>
Status RowScan::push_samples(const std::uint8_t* row) {
  std::vector<Sample> samples(plan_.dims[0]);
  detail::wire::ByteReader bytes(row, plan_.row_bytes());
  for (Sample& sample : samples) sample = static_cast<Sample>(bytes.get(sizeof(Sample)));
  const auto count = static_cast<std::uint32_t>(samples.size());
  return std::visit([&](auto& extractor) { return extractor.push(samples.data(), count).status; },
                    extractor_);
}

void RowScan::push(const std::uint8_t* row) {
  meshing::with_scanner_type(plan_.type,
                             [&](auto type) { require(push_samples<decltype(type)>(row)); });
  ++rows_;
}

void RowScan::skip(std::uint32_t rows) {
  const std::uint32_t count = std::min(rows, plan_.rows() - rows_);
  for (std::uint32_t i = 0; i < count; ++i)
    require(std::visit(
        [](auto& extractor) { return extractor.skip_row(Substitute::previous_row).status; },
        extractor_));
  rows_ += count;
}

void RowScan::finish() {
  const bool slice_is_whole = rows_ % plan_.dims[1] == 0;
  if (!slice_is_whole) return abandon();
  require(std::visit([](auto& extractor) { return extractor.finish(); }, extractor_));
}

void RowScan::abandon() {
  require(std::visit([](auto& extractor) { return extractor.abandon(); }, extractor_));
}

Statistics RowScan::statistics() const {
  return std::visit([](const auto& extractor) { return extractor.statistics(); }, extractor_);
}

void RowScan::report(std::ostream& out) const {
  const Statistics statistics = this->statistics();
  out << "rows " << rows_ << '\n'
      << "rows_planned " << plan_.rows() << '\n'
      << "rows_skipped " << statistics.skipped_rows << '\n'
      << "slices " << rows_ / plan_.dims[1] << '\n'
      << "regions " << statistics.regions << '\n'
      << "stream_bytes " << encoder_.bytes() << '\n';
}

}  // namespace discmc::device
