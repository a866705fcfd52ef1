#include "verdict.hpp"

#include <algorithm>

#include "reference.hpp"

namespace discmc::simulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

bool was_sent_whole(const ScannerBehaviour& scanner, std::uint32_t row) {
  return scanner.dropped.count(row) == 0 && scanner.damaged.count(row) == 0;
}

// Returns the rows below `end` of a set that were not skipped, as text.
std::string unmarked(const std::set<std::uint32_t>& rows, std::uint32_t end,
                     const ReceivedStream& stream) {
  std::string list;
  for (const std::uint32_t row : rows)
    if (row < end && stream.skipped().count(row) == 0) list += " " + std::to_string(row);
  return list;
}

void check_skipped(const ScannerBehaviour& scanner, std::uint32_t end, const ReceivedStream& stream,
                   std::vector<std::string>& mistakes) {
  const std::string missing =
      unmarked(scanner.dropped, end, stream) + unmarked(scanner.damaged, end, stream);
  if (!missing.empty())
    mistakes.push_back("rows that did not arrive and are not marked as skipped:" + missing);
  const std::size_t lost = overruns(scanner, stream);
  if (scanner.waits_for_credit && lost > 0)
    mistakes.push_back(std::to_string(lost) +
                       " rows are marked as skipped although there was room when they were sent");
  if (stream.report().totals.skipped_rows != stream.skipped().size())
    mistakes.push_back("the stream marks " + std::to_string(stream.skipped().size()) +
                       " skipped rows and counts " +
                       std::to_string(stream.report().totals.skipped_rows));
}

// Compares the stream with equally many bytes of the reference.
void compare(const Bytes& stream, const Bytes& reference, const std::string& name,
             std::vector<std::string>& mistakes) {
  const auto [wrong, right] =
      std::mismatch(stream.begin(), stream.end(), reference.begin(), reference.end());
  if (wrong == stream.end()) return;
  mistakes.push_back(name + " differs at byte " + std::to_string(wrong - stream.begin()) + " of " +
                     std::to_string(stream.size()) + " from the extraction here, which has " +
                     std::to_string(reference.size()) +
                     " bytes: is --memory the arena_bytes of the firmware?");
}

}  // namespace

std::size_t overruns(const ScannerBehaviour& scanner, const ReceivedStream& stream) {
  const auto& skipped = stream.skipped();
  return static_cast<std::size_t>(
      std::count_if(skipped.begin(), skipped.end(),
                    [&](const auto& row) { return was_sent_whole(scanner, row.first); }));
}

std::vector<std::string> mistakes(const Rows& rows, const Options& options,
                                  const Received& received) {
  std::vector<std::string> mistakes;
  const ReceivedStream& last = received.stream();
  const StreamReport& report = last.report();
  const std::uint32_t end = std::min(rows.count(), options.scanner.broken_off_at);
  const bool is_broken_off = end < rows.count();

  const std::size_t resets = options.reset_at < end ? 1 : 0;
  if (received.streams().size() != resets + 1)
    mistakes.push_back("the device began " + std::to_string(received.streams().size()) +
                       " streams and was reset " + std::to_string(resets) + " times");
  if (!report.is_complete() || report.damaged_packets > 0)
    mistakes.push_back("the stream is not complete: " + std::to_string(report.lost_packets) +
                       " packets are lost, " + std::to_string(report.damaged_packets) +
                       " are damaged");
  if (report.is_abandoned != is_broken_off)
    mistakes.emplace_back(report.is_abandoned ? "the device abandoned a scan that had its end"
                                              : "the device finished a scan that was broken off");
  check_skipped(options.scanner, end, last, mistakes);

  const auto reference = [&](const ReceivedStream& stream) {
    return reference_stream(rows,
                            {last.header(), options.memory, stream.skipped(), end, is_broken_off});
  };
  for (const auto& stream : received.streams())
    if (stream->bytes() != last.bytes())
      compare(stream->bytes(), reference(*stream), "the stream before the reset", mistakes);
  const Bytes expected = reference(last);
  compare(last.bytes(), expected, "the stream", mistakes);
  if (last.bytes().size() < expected.size())
    mistakes.push_back("the stream ends after " + std::to_string(last.bytes().size()) + " of " +
                       std::to_string(expected.size()) + " bytes");
  return mistakes;
}

}  // namespace discmc::simulator
