// Output files: their format by their name, and nothing half-written under it.
#include "output_file.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "command.hpp"
#include "hand_made.hpp"

namespace {

using command::contains;
using command::contents;
using discmc::host::Format;
using discmc::host::format_of;
using discmc::host::OutputFile;
using discmc::host::write_surface;
using volume_files::Folder;

std::string written(Format format, bool conforming) {
  std::ostringstream out;
  write_surface(hand_made::leaning_wall(), format, conforming, {}, out);
  return out.str();
}

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

TEST_CASE("an output's format is told by its extension") {
  CHECK(format_of("a.dmc") == Format::stream);
  CHECK(format_of("-") == Format::stream);
  CHECK(format_of("a.stl.obj") == Format::obj);
  CHECK(format_of("folder.stl/a.ply") == Format::ply);
  CHECK(format_of("a b.stl") == Format::stl);
  CHECK(format_of("../a.jsonl") == Format::jsonl);
  CHECK(format_of("A.STL") == Format::stl);
}

TEST_CASE("an unknown extension is refused by name, and those that are known are told") {
  for (const char* name : {"a.vtk", "a", "a.", "folder.stl/a", "a.stl.gz", "--", ".obj"}) {
    const std::string text = complaint([name] { format_of(name); });
    INFO(text);
    CHECK(contains(text, std::string(name) + ": "));
    for (const char* known : {".dmc", ".obj", ".ply", ".stl", ".jsonl"})
      CHECK(contains(text, known));
  }
}

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

TEST_CASE("surfaces are written in the format asked for, with or without vertices of neighbours") {
  CHECK(written(Format::ply, true).substr(0, 4) == "ply\n");
  CHECK(written(Format::jsonl, true).substr(0, 10) == "{\"normal\":");
  const std::size_t triangles = (written(Format::stl, true).size() - 84) / 50;
  CHECK(triangles > hand_made::leaning_wall().polygons.size());
  for (const Format format : {Format::obj, Format::ply, Format::stl})
    CHECK(written(format, true).size() > written(format, false).size());
  CHECK(written(Format::jsonl, true) == written(Format::jsonl, false));
  CHECK_THROWS_AS(written(Format::stream, true), std::invalid_argument);
}
