// The result type of all calls.
#ifndef DISCMC_STATUS_HPP
#define DISCMC_STATUS_HPP

#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

/// The result of a call. docs/statuses.md has the cause and the remedy of each status.
///
/// `ok` and `suspended` are not errors. After `suspended`, call resume() of the object until it
/// returns another status, then the same function with what it has not accepted. After an error,
/// the object continues as if the call had not been made. Exceptions: waiting events may have been
/// delivered, and push() may have accepted some input. If an error changes more, the comment of the
/// function states it.
enum class Status : uint8_t {
  ok,
  suspended,          ///< work remains: the sink or output is busy, or it was one step of several
  bad_limits,         ///< see Limits
  bad_capacities,     ///< a capacity is below the minimum or beyond the index type
  too_little_memory,  ///< the memory is null or smaller than the limits or capacities need
  bad_sink,           ///< no function; a sink that has not started; a bad ByteOutput::max_frame
  not_started,        ///< start() has not succeeded; for records, also start() of the extractor
  finished,           ///< the scan has ended: start() another, or reset(); of a Receiver: push on
  row_in_progress,    ///< a whole row was pushed or skipped in the middle of a row
  slice_in_progress,  ///< finish() in the middle of a slice: push or skip its rows, or abandon()
  too_many_slices,    ///< the scan has the most slices that it may have; finish() still works
  wrong_version,      ///< this decoder does not support the stream's version
  bad_checkpoint,     ///< the checkpoint or its memory differs from what was saved
  bad_label,          ///< see StreamLabel; a bad surface_count or levels of a SliceEncoderConfig
  bad_record,         ///< an application record or a packet of records is too long
  bad_device,         ///< a flash without read() or program(), or too small for two checkpoints
  device_error,       ///< a flash function failed, or a unit reads back with other bytes
};

/// A short English text for a status. Owner: static storage.
constexpr const char* to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::suspended:
      return "work remains, for example because the sink or output is busy: call resume(), or "
             "push() the remaining bytes to a decoder";
    case Status::bad_limits:
      return "invalid limits: width and height must be 1 to 32766; check border, slab and "
             "crop; a lean extractor has no open border and no slab";
    case Status::bad_capacities:
      return "a capacity is below its minimum or beyond the index type: use the default "
             "capacities; a row ring needs a row";
    case Status::too_little_memory:
      return "the memory is null or too small: size it with ..._bytes() of the object or sizes.h; "
             "slice decoders have set_memory(), stores max_bytes";
    case Status::bad_sink:
      return "the sink or output is incomplete: set write(), and unsent() for checkpoints; start "
             "the encoder first; max_frame is 0 or 48 to 256";
    case Status::not_started:
      return "start() was not called or failed: check its status; an encoder accepts records after "
             "start() of the extractor";
    case Status::slice_in_progress:
      return "the current slice is incomplete: push or skip its rows, or call abandon()";
    case Status::finished:
      return "the scan has ended: start another";
    case Status::row_in_progress:
      return "the current row is incomplete: push the rest of it first";
    case Status::too_many_slices:
      return "the scan has the maximum of 1073741823 slices: finish() it, and start another";
    case Status::wrong_version:
      return "the stream has another format version: use a receiver of that version";
    case Status::bad_checkpoint:
      return "there is no checkpoint, or it is damaged, or its build, kind, parts or alignment "
             "differ: start a new scan";
    case Status::bad_label:
      return "invalid label: channels are 0 to 63, surfaces 1 to 4, levels of fractions 2 or 4";
    case Status::bad_record:
      return "an application record has more than 200 bytes, or a packet of records is too long: "
             "split the data";
    case Status::bad_device:
      return "the flash has no read() or program(), no room for two checkpoints, or units below 16 "
             "bytes or not fitting blocks: correct its geometry";
    case Status::device_error:
      return "a flash function failed, or the flash reads back other bytes: save again, and check "
             "the driver";
  }
  return "unknown status";
}

}  // namespace discmc

#endif
