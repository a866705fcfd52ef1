// Formats, by the names of files.
#include "mesh_files/file_format.hpp"

#include <stdexcept>

#include "test.hpp"

using discmc::command::Format;
using discmc::command::format_of;

TEST_CASE("the extension of an output selects its format") {
  CHECK(format_of("a.dmc") == Format::stream);
  CHECK(format_of("-") == Format::stream);
  CHECK(format_of("a.stl.obj") == Format::obj);
  CHECK(format_of("folder.stl/a.ply") == Format::ply);
  CHECK(format_of("a b.stl") == Format::stl);
  CHECK(format_of("../a.jsonl") == Format::jsonl);
  CHECK(format_of("A.STL") == Format::stl);
}

TEST_CASE("an unknown extension is refused by name with the supported ones") {
  for (const char* name : {"a.vtk", "a", "a.", "folder.stl/a", "a.stl.gz", "--", ".obj"}) {
    INFO(name);
    CHECK_THROWS_WITH_AS(format_of(name), doctest::Contains((std::string(name) + ": ").c_str()),
                         std::invalid_argument);
    CHECK_THROWS_WITH(
        format_of(name),
        doctest::Contains("use .dmc, .stl, .ply, .obj, .glb, .3mf, .vtp, .jsonl, .csv or .json"));
  }
}
