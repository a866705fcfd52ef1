#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/receiver.hpp>

struct discmc_receiver {
  discmc::WithSink<discmc::Receiver> with_sink;
};

namespace discmc {

static_assert(red_zone_bytes > 0 || DISCMC_RECEIVER_BYTES(31, 7, 2) >=
                                        bytes_with_object(sizeof(discmc_receiver),
                                                          Receiver::minimum_bytes({31, 7}, 2)),
              "the size in sizes.h suffices");

extern "C" {

uint64_t discmc_receiver_bytes(const discmc_limits* limits, uint32_t surface_count,
                               uint32_t levels) {
  return bytes_with_object(
      sizeof(discmc_receiver),
      limits == nullptr ? 0 : Receiver::minimum_bytes(cpp(*limits), surface_count, levels));
}

discmc_status discmc_receiver_start(discmc_receiver** receiver,
                                    const discmc_receiver_config* config) {
  Memory rest;
  auto* const object = begin<discmc_receiver>(config->memory, rest);
  if (object == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  const Status status = object->with_sink.object.start(
      rest, object->with_sink.set_sink(config->sink), config->channel);
  if (status == Status::ok) *receiver = object;
  return c(status);
}
discmc_push_result discmc_receiver_push(discmc_receiver* receiver, const uint8_t* bytes,
                                        size_t count) {
  const Decoded decoded = receiver->with_sink.object.push(bytes, count);
  return {c(decoded.status), decoded.bytes};
}
discmc_status discmc_receiver_set_memory(discmc_receiver* receiver, discmc_memory memory) {
  return c(receiver->with_sink.object.set_memory(cpp(memory)));
}
discmc_status discmc_receiver_finish(discmc_receiver* receiver) {
  return c(receiver->with_sink.object.finish());
}

discmc_receiver_info discmc_receiver_get_info(const discmc_receiver* receiver) {
  const StreamHeader& header = receiver->with_sink.object.header();
  const StreamReport& report = receiver->with_sink.object.report();
  return {{header.width,
           header.height,
           header.depth,
           {header.spacing_nm[0], header.spacing_nm[1], header.spacing_nm[2]},
           {header.thresholds[0], header.thresholds[1], header.thresholds[2], header.thresholds[3]},
           static_cast<uint8_t>(header.border),
           header.channel,
           header.scan,
           header.surface_count,
           header.levels},
          report.has_header,
          report.has_trailer,
          report.holds_slices,
          report.is_abandoned,
          report.is_complete(),
          report.is_unreadable,
          report.is_mixed,
          report.bytes,
          report.packets,
          report.repeated_packets,
          report.damaged_packets,
          report.foreign_packets,
          report.lost_packets,
          report.lost_pieces,
          report.regions,
          report.fragments,
          report.rows,
          report.lost_rows,
          report.total_rows,
          report.slices,
          c(report.totals)};
}

}  // extern "C"

}  // namespace discmc
