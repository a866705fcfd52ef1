#include <discmc/checkpoint_store.hpp>

#include <discmc/base/checks.hpp>
#include <discmc/base/compiler.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc {

namespace {

// Whether a sequence number is older than another: after the highest number comes 0.
bool is_before(uint32_t sequence, uint32_t other) {
  return static_cast<int32_t>(sequence - other) < 0;
}

uint32_t checksum_of(const StoredHead& head) {
  return crc32(reinterpret_cast<const uint8_t*>(&head), offsetof(StoredHead, checksum));
}

}  // namespace

Status CheckpointStore::start(const FlashDevice& device, uint32_t max_bytes, Memory buffer) {
  const StorePlan plan = store_plan(device.geometry, max_bytes);
  if (device.read == nullptr || device.program == nullptr || !plan.is_valid())
    return Status::bad_device;
  if (buffer.data == nullptr || buffer.bytes < device.geometry.program_bytes)
    return Status::too_little_memory;
  device_ = device;
  plan_ = plan;
  buffer_ = static_cast<uint8_t*>(buffer.data);
  is_saving_ = false;
  sequence_ = 0;
  slot_ = 0;
  erased_ = 0;
  return find_newest();
}

// ---- finding and reading ----

// Searches checkpoints from the newest on. The number of a damaged checkpoint is not used again.
Status CheckpointStore::find_newest() {
  has_newest_ = false;
  has_read_failed_ = false;
  StoredHead head{}, bound{};
  for (uint32_t looked_at = 0; looked_at < plan_.slots; ++looked_at) {
    if (!find_head_before(looked_at > 0 ? &bound : nullptr, head, newest_)) break;
    if (looked_at == 0) sequence_ = head.sequence;
    bound = head;
    has_newest_ = is_whole(newest_, head);
    if (!has_newest_) continue;
    newest_bytes_ = head.bytes;
    newest_sequence_ = head.sequence;
    slot_ = newest_;
    skip_to_next_blocks();  // the rest of its block may be partly written
    return Status::ok;
  }
  return has_read_failed_ ? Status::device_error : Status::ok;
}

// Finds the newest header older than `bound`, or of all, and its slot. Returns false if there
// is none.
bool CheckpointStore::find_head_before(const StoredHead* bound, StoredHead& head, uint32_t& slot) {
  bool is_found = false;
  for (uint32_t at = 0; at < plan_.slots; ++at) {
    StoredHead other;
    if (!read_head(at, other)) continue;
    if (bound != nullptr && !is_before(other.sequence, bound->sequence)) continue;
    if (is_found && !is_before(head.sequence, other.sequence)) continue;
    is_found = true;
    head = other;
    slot = at;
  }
  return is_found;
}

bool CheckpointStore::read_head(uint32_t slot, StoredHead& head) {
  if (!read(slot, 0)) return false;
  copy_bytes(&head, buffer_, sizeof head);
  return head.format == StoredHead::current_format && head.checksum == checksum_of(head);
}

bool CheckpointStore::is_whole(uint32_t slot, const StoredHead& head) {
  if (head.bytes > plan_.max_bytes) return false;
  const Memory unseen{nullptr, head.bytes};
  set_pieces(&unseen, 1);
  return read_slot(slot) == Status::ok;
}

// The lengths in flash belong to the newest checkpoint, which start() or save() verified.
Status CheckpointStore::restore(const Memory* parts, uint32_t count) {
  if (!is_started()) return Status::not_started;
  cancel_save();
  if (!has_checkpoint() || count > max_parts) return Status::bad_checkpoint;
  set_pieces(nullptr, 0);
  if (const Status status = read_slot(newest_); status == Status::device_error) return status;
  Memory fitting[max_parts];
  uint64_t bytes = 0;
  for (uint32_t i = 0; i < max_parts; ++i) {
    if (lengths_[i] > (i < count ? parts[i].bytes : 0)) return Status::bad_checkpoint;
    if (i < count) fitting[i] = {parts[i].data, lengths_[i]};
    bytes += lengths_[i];
  }
  if (bytes != newest_bytes_) return Status::bad_checkpoint;
  set_pieces(fitting, count);
  return read_slot(newest_);
}

// Reads into the pieces.
Status CheckpointStore::read_slot(uint32_t slot) {
  begin_pieces();
  for (uint32_t unit = 0; pieces_.at < pieces_.count; ++unit) {
    if (!read(slot, unit)) return Status::device_error;
    move_pieces(false);
  }
  return tail_ == pieces_.checksum ? Status::ok : Status::bad_checkpoint;
}

// Reads a unit into the buffer.
bool CheckpointStore::read(uint32_t slot, uint32_t unit) {
  uint32_t block, offset;
  place_of(slot, unit, block, offset);
  if (device_.read(device_.context, block, offset, buffer_, device_.geometry.program_bytes) == 0)
    return true;
  has_read_failed_ = true;
  return false;
}

// ---- the bytes of a slot ----

// Sets the parts to save. Returns false if there are too many parts or bytes, or a part is null.
bool CheckpointStore::set_parts(const Memory* parts, uint32_t count) {
  if (count > max_parts) return false;
  uint32_t bytes = 0;
  for (uint32_t i = 0; i < max_parts; ++i) {
    const size_t length = i < count ? parts[i].bytes : 0;
    if (length > plan_.max_bytes - bytes || (length > 0 && parts[i].data == nullptr)) return false;
    lengths_[i] = static_cast<uint32_t>(length);
    bytes += lengths_[i];
  }
  head_.bytes = bytes;
  set_pieces(parts, count);
  return true;
}

void CheckpointStore::set_pieces(const Memory* parts, uint32_t count) {
  uint32_t piece = 0;
  pieces_.memory[piece++] = {&head_, sizeof head_};
  pieces_.memory[piece++] = {lengths_, sizeof lengths_};
  for (uint32_t i = 0; i < count; ++i) {
    pieces_.memory[piece++] = parts[i];
    unpoison(parts[i].data, parts[i].bytes);  // an earlier scan may have left it poisoned
  }
  pieces_.memory[piece++] = {&tail_, sizeof tail_};
  pieces_.count = piece;
}

void CheckpointStore::begin_pieces() {
  pieces_.at = 0;
  pieces_.offset = 0;
  pieces_.checksum = 0;
}

// Copies the part of the pieces in one unit into the buffer or out of it. Null memory is skipped.
// The checksum continues from that of the header. A CRC over the header with its own CRC would be
// the same for every header. Then a new header would complete an older checkpoint behind it.
void CheckpointStore::move_pieces(bool is_to_unit) {
  uint32_t done = 0;
  while (done < device_.geometry.program_bytes && pieces_.at < pieces_.count) {
    const Memory& piece = pieces_.memory[pieces_.at];
    const bool is_tail = pieces_.at + 1 == pieces_.count;
    if (is_tail && is_to_unit) tail_ = pieces_.checksum;
    const size_t left = piece.bytes - pieces_.offset;
    const uint32_t room = device_.geometry.program_bytes - done;
    const uint32_t count = left < room ? static_cast<uint32_t>(left) : room;
    uint8_t* const bytes = static_cast<uint8_t*>(piece.data);
    for (uint32_t i = 0; bytes != nullptr && i < count; ++i) {
      uint8_t& outside = bytes[pieces_.offset + i];
      if (is_to_unit)
        buffer_[done + i] = outside;
      else
        outside = buffer_[done + i];
    }
    if (pieces_.at == 0)
      pieces_.checksum = head_.checksum;
    else if (!is_tail)
      pieces_.checksum = crc32(buffer_ + done, count, pieces_.checksum);
    done += count;
    pieces_.offset += count;
    if (pieces_.offset < piece.bytes) continue;
    ++pieces_.at;
    pieces_.offset = 0;
  }
  for (; is_to_unit && done < device_.geometry.program_bytes; ++done) buffer_[done] = 0xFF;
}

// ---- writing ----

Status CheckpointStore::erase_ahead(uint32_t bytes) {
  if (!is_started()) return Status::not_started;
  const uint32_t blocks = plan_.blocks(bytes < plan_.max_bytes ? bytes : plan_.max_bytes);
  if (erased_ >= blocks) return Status::ok;
  if (!erase_block()) return fail();
  return erased_ < blocks ? Status::suspended : Status::ok;
}

Status CheckpointStore::save(const Memory* parts, uint32_t count) {
  if (!is_started()) return Status::not_started;
  cancel_save();
  if (!set_parts(parts, count) || head_.bytes == 0) return Status::too_little_memory;
  return begin_save();
}

// An entry without bytes is newer than every checkpoint.
Status CheckpointStore::discard() {
  if (!is_started()) return Status::not_started;
  cancel_save();
  if (!has_checkpoint()) return Status::ok;
  (void)set_parts(nullptr, 0);
  return begin_save();
}

Status CheckpointStore::begin_save() {
  begin_pieces();
  head_.format = StoredHead::current_format;
  head_.sequence = ++sequence_;
  head_.checksum = checksum_of(head_);
  unit_ = 0;
  is_saving_ = true;
  return step();
}

Status CheckpointStore::resume() {
  if (!is_started()) return Status::not_started;
  return is_saving_ ? step() : Status::ok;
}

Status CheckpointStore::step() {
  const bool is_in_erased = plan_.slots_per_block > 1
                                ? erased_ > 0
                                : unit_ / device_.geometry.units_per_block() < erased_;
  if (!is_in_erased) return erase_block() ? Status::suspended : fail();
  if (!program_unit()) return fail();
  if (pieces_.at < pieces_.count) return Status::suspended;
  if (device_.sync != nullptr && device_.sync(device_.context) != 0) return fail();
  complete();
  return Status::ok;
}

bool CheckpointStore::erase_block() {
  uint32_t block, offset;
  place_of(slot_, 0, block, offset);
  if (device_.erase != nullptr && device_.erase(device_.context, block + erased_) != 0)
    return false;
  ++erased_;
  return true;
}

bool CheckpointStore::program_unit() {
  const uint32_t bytes = device_.geometry.program_bytes;
  uint32_t block, offset;
  place_of(slot_, unit_, block, offset);
  move_pieces(true);
  const uint32_t checksum = crc32(buffer_, bytes);
  if (device_.program(device_.context, block, offset, buffer_, bytes) != 0) return false;
  if (!read(slot_, unit_) || crc32(buffer_, bytes) != checksum) return false;
  ++unit_;
  return true;
}

// The position of a unit of a slot. Either a block contains slots, or a slot contains blocks.
void CheckpointStore::place_of(uint32_t slot, uint32_t unit, uint32_t& block,
                               uint32_t& offset) const {
  const uint32_t per_block = device_.geometry.units_per_block();
  const uint32_t in_group = slot % plan_.slots_per_block * plan_.slot_units + unit;
  block = group_of(slot) * plan_.blocks_per_slot + in_group / per_block;
  offset = in_group % per_block * device_.geometry.program_bytes;
}

// Selects the following slot, in the same erased block if that has room.
void CheckpointStore::complete() {
  is_saving_ = false;
  has_newest_ = true;
  newest_ = slot_;
  newest_bytes_ = head_.bytes;
  newest_sequence_ = head_.sequence;
  slot_ = slot_ + 1 < plan_.slots ? slot_ + 1 : 0;
  erased_ = slot_ % plan_.slots_per_block != 0 ? 1 : 0;
}

Status CheckpointStore::fail() {
  is_saving_ = false;
  skip_to_next_blocks();
  return Status::device_error;
}

void CheckpointStore::cancel_save() {
  if (is_saving_ && unit_ > 0) skip_to_next_blocks();
  is_saving_ = false;
}

// Continues with the next blocks without the newest checkpoint; nothing in them counts as erased.
void CheckpointStore::skip_to_next_blocks() {
  const uint32_t groups = group_of(plan_.slots);
  uint32_t next = group_of(slot_) + 1;
  if (next == groups) next = 0;
  if (has_newest_ && next == group_of(newest_) && ++next == groups) next = 0;
  slot_ = next * plan_.slots_per_block;
  erased_ = 0;
}

}  // namespace discmc
