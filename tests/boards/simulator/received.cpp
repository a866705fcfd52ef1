#include "received.hpp"

#include <algorithm>
#include <stdexcept>

namespace discmc::simulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Returns the position, from `from` on, at which the first frame recurs, or the end.
Bytes::const_iterator second_beginning(const Bytes& bytes, std::size_t from) {
  const auto end_of_frame = std::find(bytes.begin(), bytes.end(), 0);
  if (end_of_frame == bytes.end()) return bytes.end();
  const auto begin = std::max(end_of_frame + 1, bytes.begin() + static_cast<std::ptrdiff_t>(from));
  return std::search(begin, bytes.end(), bytes.begin(), end_of_frame + 1);
}

}  // namespace

ReceivedStream::ReceivedStream() {
  if (decoder_.start(make_sink(*this)) != Status::ok) throw std::logic_error("the sink is no sink");
}

// The zeros before the first frame end a frame that a reset has cut.
void ReceivedStream::push(const std::uint8_t* bytes, std::size_t count) {
  for (; bytes_.empty() && count > 0 && *bytes == 0; --count) ++bytes;
  bytes_.insert(bytes_.end(), bytes, bytes + count);
  const Status status = decoder_.push(bytes, count).status;
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

void ReceivedStream::finish() {
  const Status status = decoder_.finish();
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

SinkResult ReceivedStream::accept(const Event& event) {
  if (event.kind == Event::Kind::layer || event.kind == Event::Kind::finish)
    final_slices_ = event.slice;
  if (event.kind == Event::Kind::skipped)
    skipped_[event.slice * header().height + event.row] =
        event.is_repeated ? Substitute::previous_row : Substitute::off;
  return SinkResult::accepted;
}

Received::Received() {
  streams_.push_back(std::make_unique<ReceivedStream>());
}

void Received::push(const std::uint8_t* bytes, std::size_t count) {
  ReceivedStream& current = *streams_.back();
  const std::size_t seen = current.bytes().size();
  current.push(bytes, count);
  const auto beginning =
      second_beginning(current.bytes(), seen - std::min(seen, detail::wire::max_frame));
  if (beginning == current.bytes().end()) return;

  // The decoder of the old stream has read bytes of the new one, so both start again.
  const Bytes before(current.bytes().begin(), beginning - 1);  // without the zero
  const Bytes after(beginning, current.bytes().end());
  streams_.back() = std::make_unique<ReceivedStream>();
  streams_.back()->push(before.data(), before.size());
  streams_.back()->finish();
  streams_.push_back(std::make_unique<ReceivedStream>());
  streams_.back()->push(after.data(), after.size());
}

}  // namespace discmc::simulator
