#include "version_search.hpp"

namespace discmc::host {

VersionSearch::VersionSearch() {
  newest_.start(any_channel);
}

void VersionSearch::take(std::uint8_t byte) {
  is_version1_ = version1_.take(byte);
  static_cast<void>(newest_.take(byte));
  // A version that neither knows is the newest's to refuse.
  is_over_ =
      is_version1_ || newest_.report().has_header || newest_.is_refused() || ++bytes_ == most_bytes;
}

}  // namespace discmc::host
