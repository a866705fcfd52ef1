// Output files: nothing half-written appears under their name.
#include "output_file.hpp"

#include <doctest/doctest.h>

#include <string>

#include "command.hpp"

namespace {

using command::contains;
using command::contents;
using discmc::host::OutputFile;
using volume_files::Folder;

// What is said of a file that cannot be written.
template <class Write>
std::string complaint(Write write) {
  try {
    write();
  } catch (const std::exception& error) {
    return error.what();
  }
  FAIL("no error");
  return {};
}

}  // namespace

TEST_CASE("a file appears when it is complete and not before") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  {
    OutputFile file(path);
    file.stream() << "text";
    file.stream().flush();
    CHECK(!std::filesystem::exists(path));
    file.commit();
    CHECK(contents(path) == "text");
  }
  CHECK(contents(path) == "text");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("what is not committed leaves no trace, and the file of before as it was") {
  const Folder folder;
  const auto path = folder.write("a.obj", "before");
  {
    OutputFile file(path);
    file.stream() << std::string(100000, 'x');
  }
  CHECK(contents(path) == "before");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  OutputFile file(path);
  file.stream() << "after";
  file.commit();
  CHECK(contents(path) == "after");
}

TEST_CASE("a stream that failed is not committed") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  {
    OutputFile file(path);
    file.stream() << "text";
    file.stream().setstate(std::ios::badbit);
    const std::string text = complaint([&file] { file.commit(); });
    CHECK(contains(text, path.string()));
    CHECK(contains(text, "disk"));
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a file in a folder that is not there is refused by name") {
  const Folder folder;
  const auto path = folder.path() / "none" / "a.obj";
  const std::string text = complaint([&path] { OutputFile file(path); });
  CHECK(contains(text, path.string()));
  CHECK(contains(text, "folder"));
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a folder is not replaced by a file") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  std::filesystem::create_directory(path);
  const std::string text = complaint([&path] {
    OutputFile file(path);
    file.stream() << "text";
    file.commit();
  });
  CHECK(contains(text, path.string()));
  CHECK(std::filesystem::is_directory(path));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
