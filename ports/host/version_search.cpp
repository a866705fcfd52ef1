#include "version_search.hpp"

namespace discmc::host {

VersionSearch::VersionSearch() {
  const auto ignore = [](void*, const Event&) { return Answer::taken; };
  static_cast<void>(newest_.start({nullptr, ignore}));
}

void VersionSearch::take(std::uint8_t byte) {
  is_version1_ = version1_.take(byte);
  const Status status = newest_.push(&byte, 1).status;
  // A version that neither knows is the newest's to refuse.
  is_over_ =
      is_version1_ || newest_.report().has_header || status != Status::ok || ++bytes_ == most_bytes;
}

}  // namespace discmc::host
