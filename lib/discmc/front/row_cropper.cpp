#include <discmc/front/row_cropper.hpp>

namespace discmc {

Status RowCropper::start(const Limits& incoming, const CropRange& x, const CropRange& y,
                         const CropRange& z) {
  if (!incoming.is_valid() || x.step == 0 || y.step == 0 || z.step == 0) return Status::bad_limits;
  const uint32_t width = x.count_of(incoming.width), height = y.count_of(incoming.height);
  if (width == 0 || height == 0 || z.count == 0) return Status::bad_limits;
  first_ = x.first;
  count_ = width;
  step_ = x.step;
  y_ = {y.first, height, y.step};
  height_ = incoming.height;
  row_ = 0;
  z_step_ = z.step;
  z_wait_ = z.first;
  z_left_ = z.count;
  border_ = incoming.border;
  return Status::ok;
}

bool RowCropper::next() {
  if (row_ == 0) {
    y_next_ = y_.first;
    const bool is_slice_picked = z_left_ > 0 && z_wait_ == 0;
    y_left_ = is_slice_picked ? y_.count : 0;
    if (is_slice_picked && z_left_ != CropRange::rest) --z_left_;
    z_wait_ = z_wait_ == 0 ? z_step_ - 1 : z_wait_ - 1;
  }
  const bool is_picked = y_left_ > 0 && row_ == y_next_;
  if (is_picked) {
    --y_left_;
    y_next_ += y_.step;
  }
  row_ = row_ + 1 == height_ ? 0 : row_ + 1;
  return is_picked;
}

void RowCropper::crop_bits(const uint8_t* bits, uint8_t* picked) const {
  uint32_t from = first_;
  for (uint32_t to = 0; to < count_; to += 8) {
    const uint32_t end = count_ - to < 8 ? count_ - to : 8;
    uint32_t byte = 0;
    for (uint32_t bit = 0; bit < end; ++bit, from += step_)
      byte |= (uint32_t{bits[from / 8]} >> from % 8 & 1) << bit;
    *picked++ = static_cast<uint8_t>(byte);
  }
}

}  // namespace discmc
