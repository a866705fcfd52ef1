// The texts of statuses.
#include <discmc/status.hpp>

#include "test.hpp"

using namespace discmc;

TEST_CASE("every status has a unique text, and other numbers have the text of an unknown status") {
  std::set<std::string> texts;
  const auto last = static_cast<int>(Status::device_error);
  for (int i = 0; i <= last; ++i) texts.insert(to_string(static_cast<Status>(i)));
  CHECK(texts.size() == static_cast<size_t>(last) + 1);
  CHECK(texts.count("unknown status") == 0);
  CHECK(to_string(static_cast<Status>(last + 1)) == std::string("unknown status"));
}
