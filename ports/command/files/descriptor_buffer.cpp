#include "descriptor_buffer.hpp"

#include <unistd.h>

#include <cerrno>

namespace discmc::command {

DescriptorBuffer::DescriptorBuffer(int descriptor) : descriptor_(descriptor) {
  setp(waiting_.data(), waiting_.data() + waiting_.size());
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type byte) {
  if (sync() != 0) return traits_type::eof();
  if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
  return sputc(traits_type::to_char_type(byte));
}

std::streamsize DescriptorBuffer::xsputn(const char* bytes, std::streamsize count) {
  if (count <= epptr() - pptr()) return std::streambuf::xsputn(bytes, count);
  return sync() == 0 && write_all(bytes, static_cast<std::size_t>(count)) ? count : 0;
}

int DescriptorBuffer::sync() {
  const bool is_written = write_all(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(waiting_.data(), waiting_.data() + waiting_.size());
  return is_written ? 0 : -1;
}

DescriptorBuffer::pos_type DescriptorBuffer::seekpos(pos_type place, std::ios_base::openmode) {
  if (sync() != 0) return pos_type(off_type(-1));
  return pos_type(lseek(descriptor_, static_cast<off_t>(place), SEEK_SET));
}

bool DescriptorBuffer::write_all(const char* bytes, std::size_t count) const {
  while (count > 0) {
    const ssize_t written = write(descriptor_, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace discmc::command
