// The one result type of the library.
#ifndef DISCMC_STATUS_HPP
#define DISCMC_STATUS_HPP

#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// Result of a call. `ok` and `suspended` are not errors: `suspended` means that the sink or output
/// said "not now" and that resume() goes on with the work; of a decoder, push() of the rest.
///
/// After an error what is under way goes on as if the call had not been made. But what comes before
/// the error is done: events that waited have been delivered, and push() tells how much it has
/// taken of what it was given. Some errors leave more behind:
///
///   Extractor::start()       too_little_memory, or bad_sink of a sink that did not take the start:
///                            the scan before has ended, too
///   MajorityFilter::start(), Downsampler::start()  whichever: it is not started
///   push() of decoders       wrong_version: nothing more of this stream comes
///   Joiner::finish()         too_little_memory: all has been done that can be
///   CheckpointStore          device_error: see each of its functions
enum class Status : uint8_t {
  ok,
  suspended,          ///< suspended; nothing is lost: resume(), of a decoder push() the rest
  bad_limits,         ///< see Limits
  bad_capacities,     ///< a capacity is below the minimum or beyond what the index type can count
  too_little_memory,  ///< the memory is smaller than the limits or capacities need, or null
  bad_sink,           ///< a sink or output without a function, or a sink that refuses to start
  not_started,        ///< start() has not succeeded yet
  finished,           ///< finish() or abandon() was called: start() another scan, or reset()
  row_in_progress,    ///< a whole row was given or skipped in the middle of a row of samples
  slice_in_progress,  ///< finish() in the middle of a slice: push or skip its rows, or abandon()
  too_deep,       ///< z coordinates are exhausted (Limits::max_slices slices); finish() still works
  wrong_version,  ///< the stream's version is not known to this decoder
  bad_checkpoint,  ///< the checkpoint, or the memory that goes with it, is not what was saved
  bad_label,       ///< see StreamLabel; of a StreamHeader also its surfaces
  bad_record,      ///< an application record is too long, or a packet of records
  bad_device,      ///< a flash without read() or program(), or without room for two checkpoints
  device_error,    ///< a function of a flash failed, or a unit reads otherwise than was programmed
};

/// A short English text for a status. Owner: static storage.
constexpr const char* to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::suspended:
      return "the sink or output is busy: call resume(), of a decoder push() the rest";
    case Status::bad_limits:
      return "width and height must be 1 to 32766, and border and slab valid";
    case Status::bad_capacities:
      return "a capacity is below its minimum or beyond the index type";
    case Status::too_little_memory:
      return "the memory is too small: see minimum_bytes(), slice_encoder_bytes() or the like";
    case Status::bad_sink:
      return "the sink or output has no function, or was not started";
    case Status::not_started:
      return "start() has not succeeded";
    case Status::slice_in_progress:
      return "the current slice is not complete: push or skip its rows, or abandon()";
    case Status::finished:
      return "the scan is finished: start() another, or reset() where there is that";
    case Status::row_in_progress:
      return "the current row is not complete";
    case Status::too_deep:
      return "more slices than a z coordinate can count";
    case Status::wrong_version:
      return "the stream's version is not known";
    case Status::bad_checkpoint:
      return "the checkpoint is torn, damaged or of another build: take the one before";
    case Status::bad_label:
      return "channels are 0 to 63, and a stream has at most 4 surfaces";
    case Status::bad_record:
      return "an application record holds at most 200 bytes, a packet of records 243";
    case Status::bad_device:
      return "the flash has no read() or program(), or no room for two checkpoints";
    case Status::device_error:
      return "the flash failed: see its driver";
  }
  return "unknown status";
}

}  // namespace discmc

#endif
