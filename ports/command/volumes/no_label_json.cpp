// In place of label_json.cpp where there is no library that reads JSON.
#include "label_json.hpp"
#include "volume_error.hpp"

namespace discmc::command {

LabelTable read_label_json(const std::filesystem::path& file) {
  fail(file, "this is JSON, and discmc was built without nlohmann-json",
       "give a table with a line per label, such as: 1 liver");
}

}  // namespace discmc::command
