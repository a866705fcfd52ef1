// The measures of surfaces, computed and as files: extract -o FILE.csv.
#include "meshes/measures.hpp"

#include "command.hpp"
#include "mesh_files/mesh_files.hpp"
#include "sample_reader.hpp"
#include "surface/components.hpp"

namespace {

using namespace discmc::command;
using namespace command_tests;
using discmc::reference::BitVolume;
using sample_reader::merged_mesh;
using sample_reader::put_box;

BitVolume two_blocks() {
  BitVolume volume({30, 20, 20});
  put_box(volume, {2, 3, 4}, {13, 14, 15}, 1);
  put_box(volume, {6, 7, 8}, {9, 9, 9}, 0);
  put_box(volume, {18, 5, 5}, {22, 9, 9}, 1);
  return volume;
}

constexpr Point spacing = {0.5, 1, 2};

}  // namespace

TEST_CASE("mesh measures count bodies and cavities, and sum the components' volumes") {
  const FileMesh mesh = merged_mesh(two_blocks(), Faces::triangles, spacing);
  const Measures measures = measures_of(mesh);
  REQUIRE(measures.enclosed);
  CHECK(measures.enclosed->bodies == 2);
  CHECK(measures.enclosed->cavities == 1);

  double volume = 0;
  for (const Component& each : components(sample_reader::surface_of(two_blocks(), spacing)))
    volume += each.volume_mm3;
  CHECK(measures.enclosed->volume_mm3 == doctest::Approx(volume).epsilon(1e-12));
}

TEST_CASE("the measures of a single voxel are those of an octahedron") {
  BitVolume one({5, 5, 5});
  put_box(one, {2, 1, 3}, {2, 1, 3}, 1);
  const Measures measures = measures_of(merged_mesh(one, Faces::triangles));
  REQUIRE(measures.enclosed);
  CHECK(measures.enclosed->volume_mm3 == doctest::Approx(1.0 / 6));
  CHECK(measures.area_mm2 == doctest::Approx(std::sqrt(3.0)));
  CHECK(measures.min_mm == Point{1.5, 0.5, 2.5});
  CHECK(measures.max_mm == Point{2.5, 1.5, 3.5});
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(measures.enclosed->centre_mm[axis] == doctest::Approx(Point{2, 1, 3}[axis]));
}

TEST_CASE("an open mesh has no enclosed volume, and an empty mesh has no extent") {
  FileMesh mesh = merged_mesh(two_blocks(), Faces::triangles);
  mesh.corners.resize(mesh.corners.size() - 3);
  mesh.face_begin.pop_back();
  mesh.name = "open, \"cut\"";
  CHECK(!measures_of(mesh).enclosed);
  std::ostringstream csv, json, empty;
  write_csv({&mesh}, csv);
  CHECK(contains(csv.str(), "\n\"open, \"\"cut\"\"\",,"));
  write_json({&mesh}, json);
  CHECK(contains(json.str(), R"("name": "open, \"cut\"", "volume_mm3": null, "area_mm2": )"));
  const FileMesh none;
  write_json({&none}, empty);
  CHECK(contains(empty.str(), R"("volume_mm3": 0, "area_mm2": 0, "bodies": 0, "cavities": 0, )"
                              R"("min_x_mm": null)"));
}

TEST_CASE_FIXTURE(Workshop, "extract and decode write measures, a line per label") {
  std::string bytes;
  BitVolume volume = two_blocks();
  put_box(volume, {18, 5, 5}, {22, 9, 9}, 2);
  for (const std::uint8_t label : volume.on) bytes += static_cast<char>(label);
  write("v.raw", bytes);
  const std::string labels = "v.raw --dims 30,20,20 --type u8 -q --labels all ";
  done("extract " + labels + "-o v.csv");
  const std::string table = read("v.csv");
  CHECK(table.rfind("name,volume_mm3,area_mm2,bodies,cavities,min_x_mm,", 0) == 0);
  CHECK(contains(table, "\n1,"));
  CHECK(contains(table, "\n2,"));
  done("extract " + labels + "--largest 1 -o v.json");
  CHECK(contains(read("v.json"), "\"bodies\": 1, \"cavities\": 0"));
  done("extract v.raw --dims 30,20,20 --type u8 -q --iso 1 -o v.dmc");
  done("decode v.dmc -o decoded.csv");
  CHECK(contains(read("decoded.csv"), ",2,1,"));
}

static std::string voxels_of(const std::string& rows, const std::string& name) {
  const std::size_t begin = rows.find("\n" + name + ",");
  if (begin == std::string::npos) return {};
  const std::string row = rows.substr(begin + 1, rows.find('\n', begin + 1) - begin - 1);
  return row.substr(row.rfind(',') + 1);
}

TEST_CASE_FIXTURE(Workshop, "--bodies writes a row per body with its cavities, largest first") {
  std::string bytes(20 * 12 * 12, '\0');
  const auto put = [&](int first, int end, char value) {
    for (int z = first; z < end; ++z)
      for (int y = first; y < end; ++y)
        for (int x = first; x < end; ++x)
          bytes[static_cast<std::size_t>((z * 12 + y) * 20 + x)] = value;
  };
  put(1, 11, 1);
  put(3, 9, 0);
  put(5, 7, 1);
  bytes[static_cast<std::size_t>((4 * 12 + 4) * 20 + 16)] = 1;
  write("v.raw", bytes);
  const std::string extract = "extract v.raw --dims 20,12,12 --spacing 2,1,1 --type u8 --iso 1 -q ";
  done(extract + "-o all.csv");
  CHECK(contains(read("all.csv"), ",793\n"));
  done(extract + "--bodies -o bodies.csv");
  const std::string rows = read("bodies.csv");
  CHECK(contains(rows, ",centre_z_mm,voxels\n"));
  CHECK(voxels_of(rows, "1 1") == "784");
  CHECK(voxels_of(rows, "1 2") == "8");
  CHECK(voxels_of(rows, "1 3") == "1");
  done(extract + "--bodies --largest 1 -o one.json");
  CHECK(contains(read("one.json"), "\"voxels\": 784"));
  CHECK(contains(run(extract + "--bodies -o v.stl").error, "only in .csv and .json"));
  CHECK(contains(run(extract + "--bodies --border open -o v.csv").error, "leave out --bodies"));
}
