// --surface interpolated and relaxed.
#include "command.hpp"
#include "meshes/surface_distance.hpp"
#include "sampled_field.hpp"

namespace {

using command_tests::check_failure;
using command_tests::mesh_of_obj;
using command_tests::Workshop;
using discmc::meshing::FaceMesh;

const std::string extract = "extract v.raw --dims 14,14,14 --type u8 -q --iso 50 ";

const sampled_field::Field ball = sampled_field::ball(14, 5.3);

struct Ball : Workshop {
  Ball() {
    std::string bytes;
    for (const int sample : ball.samples) bytes += static_cast<char>(sample);
    write("v.raw", bytes);
  }
};

}  // namespace

TEST_CASE_FIXTURE(Ball,
                  "--surface interpolated writes the library's mesh unchanged, with a default "
                  "tolerance of 0.05") {
  for (const double tolerance : {0.05, 0.2}) {
    done(extract + "--surface interpolated --tolerance " + std::to_string(tolerance) + " -o v.obj");
    const FaceMesh written = mesh_in("v.obj");
    const FaceMesh made = sampled_field::interpolated(sampled_field::extracted(ball), tolerance);
    CHECK(written.vertices_mm == made.vertices_mm);
    CHECK(written.corners == made.corners);
  }
  done(extract + "--surface interpolated -o default.obj");
  done(extract + "--surface interpolated --tolerance 0.05 -o v.obj");
  CHECK(read("default.obj") == read("v.obj"));
  done(extract + "--surface merged -o merged.obj");
  done(extract + "-o default.obj");
  CHECK(read("default.obj") == read("merged.obj"));
}

TEST_CASE_FIXTURE(Ball,
                  "--surface relaxed gives the same mesh from a volume and from its streams") {
  done(extract + "--surface relaxed --tolerance 0 -o v.obj");
  const FaceMesh relaxed = mesh_in("v.obj");
  CHECK(check_mesh(relaxed).is_closed());
  done(extract + "--tolerance 0 --surface interpolated -o interpolated.obj");
  CHECK(relaxed.vertices_mm != mesh_in("interpolated.obj").vertices_mm);
  const auto sorted = [](auto vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  for (const std::string wire : {"regions", "slices"}) {
    done(extract + "--wire " + wire + " -o v.dmc");
    done("decode v.dmc --surface relaxed --tolerance 0 --normals surface -o decoded.obj");
    const FaceMesh decoded = mesh_in("decoded.obj");
    CHECK(sorted(decoded.vertices_mm) == sorted(relaxed.vertices_mm));
    CHECK(decoded.normals.size() == decoded.vertices_mm.size());
  }
  // The picture is that of the mesh, for every input.
  done("render v.dmc --surface relaxed -o stream.png");
  done("render v.raw --dims 14,14,14 --type u8 --iso 50 --surface relaxed -o volume.png");
  done("render v.dmc -o merged.png");
  CHECK(read("stream.png") == read("volume.png"));
  CHECK(read("stream.png") != read("merged.png"));
}

TEST_CASE_FIXTURE(Ball, "a stream with levels gives the interpolated surface and the polygons") {
  done(extract + "--wire slices -o plain.dmc");
  done("decode plain.dmc -o plain.obj");
  done(extract + "--surface interpolated --tolerance 0 -o exact.obj");
  const FaceMesh exact = mesh_in("exact.obj");
  double farthest_of_less = 1;
  for (const std::string levels : {"2", "4"}) {
    done(extract + "--wire slices --levels " + levels + " -o v.dmc");
    done("decode v.dmc -o v.obj");
    CHECK(read("v.obj") == read("plain.obj"));
    done("decode v.dmc --surface interpolated --tolerance 0 -o v.obj");
    const FaceMesh mesh = mesh_in("v.obj");
    CHECK(check_mesh(mesh).is_closed());
    const double farthest = discmc::meshing::distances(mesh, exact).largest;
    CHECK(farthest < 0.75 * farthest_of_less);
    farthest_of_less = farthest;
  }
  CHECK(farthest_of_less < 0.25);
  done("render v.dmc --surface interpolated -o v.png");
}

TEST_CASE_FIXTURE(Ball, "render draws the kind of surface that --surface selects") {
  std::set<std::string> pictures;
  for (const std::string surface : {"merged", "interpolated", "relaxed"}) {
    done("render v.raw --dims 14,14,14 --type u8 --iso 50 --shade smooth --surface " + surface +
         " -o v.png");
    pictures.insert(read("v.png"));
  }
  CHECK(pictures.size() == 3);
}

TEST_CASE_FIXTURE(Ball, "a mask of two values is reported as unsuitable to interpolate") {
  std::string mask = read("v.raw");
  for (char& sample : mask) sample = static_cast<char>(static_cast<unsigned char>(sample) >= 50);
  write("mask.raw", mask);
  const std::string masked = "extract mask.raw --dims 14,14,14 --type u8 -q --iso 1 -o v.obj";
  command_tests::check_parts(run(masked + " --surface interpolated"), 0,
                             {"mask.raw: the volume has only two values, as a mask"});
  const auto warns = [&](const std::string& arguments) {
    return command_tests::contains(run(arguments).error, "two values");
  };
  CHECK(!warns(masked));
  // A third value, only in the last slice: above the others, or between them.
  for (const char third : {'\2', '\5'}) {
    std::string samples = mask;
    std::replace(samples.begin(), samples.end(), '\1', '\3');
    samples.replace(14 * 14 * 13, 14 * 14, 14 * 14, third);
    write("mask.raw", samples);
    CHECK(!warns(masked + " --surface interpolated"));
  }
  CHECK(!warns(extract + "--surface interpolated -o v.obj"));
}

TEST_CASE_FIXTURE(Ball, "normals of an extracted interpolated ball are close to its radii") {
  for (const std::string normals : {"surface", "gradient"}) {
    done(extract + "--surface interpolated --normals " + normals + " -o v.obj");
    const FaceMesh mesh = mesh_in("v.obj");
    REQUIRE(mesh.normals.size() == mesh.vertices_mm.size());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
      const auto radius = discmc::meshing::difference(mesh.vertices_mm[i], {6.5, 6.5, 6.5});
      CHECK(discmc::meshing::dot(mesh.normals[i], discmc::meshing::unit_or_zero(radius)) > 0.9);
    }
  }
}

TEST_CASE_FIXTURE(Ball, "--surface interpolated refuses polygons, streams and labels") {
  done(extract + "--wire slices -o s.dmc");
  const std::string interpolated = extract + "--surface interpolated ";
  fails(interpolated + "-o v.dmc", 2, {"--surface", "v.dmc"});
  fails("decode s.dmc --surface interpolated -o v.ply", 1, {"s.dmc", "give --surface relaxed"});
  fails(extract + "--levels 4 -o v.dmc", 2, {"--levels", "--wire slices"});
  fails(extract + "--wire slices --levels 4 --median 3 -o v.dmc", 2, {"--levels", "--median"});
  fails("decode s.dmc --surface relaxed -o v.jsonl", 2, {"--surface"});
  fails(
      "view v.raw --dims 14,14,14 --type u8 --iso 50 --surface relaxed "
      "--no-open -o v.html",
      2, {"--surface", "applies to streams"});
  fails("decode s.dmc --tolerance 0.1 -o v.ply", 2, {"--tolerance"});
  fails("render s.dmc --surface interpolated -o v.png", 1, {"--levels 4"});
  fails(
      "extract v.raw --dims 14,14,14 --type u8 --labels all --surface "
      "relaxed -o v-{name}.ply",
      2, {"--labels", "walls"});
  fails(interpolated + "--tolerance=-1 -o v.ply", 2, {"invalid value '-1'; expected 0 or more"});
  fails(interpolated + "--tolerance inf -o v.ply", 2, {"'inf'"});
  fails(
      "extract v.raw --dims 14,14,14 --type u8 --label 1 --surface "
      "interpolated -o v.ply",
      2, {"--surface", "labels"});
}
