// Runs the built command in a folder of its own, and reads the meshes that it writes.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

#include "mesh_files/file_mesh.hpp"
#include "mesh_formats.hpp"
#include "oracle/volume.hpp"
#include "volume_files.hpp"

namespace command_tests {

using discmc::command::FileMesh;
using discmc::meshing::Point;
using discmc::reference::BitVolume;
using volume_files::contains;
using volume_files::contents;

/// The result of a run. If a signal ended the run, the code is 128 plus the signal, as in shells.
struct Result {
  int code;
  std::string out, error;
};

inline FileMesh mesh_of(const std::string& name, const std::string& bytes);

/// A folder in which the command runs.
class Workshop {
 public:
  /// Runs a line of shell. "$discmc" is the command.
  Result shell(const std::string& line) const {
    const auto out = logs_.path() / "out", error = logs_.path() / "error";
    const std::string whole = "discmc='" DISCMC_COMMAND "'; cd '" + folder_.path().string() +
                              "' && { " + line + "\n} >'" + out.string() + "' 2>'" +
                              error.string() + "'";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, contents(out), contents(error)};
  }

  /// Runs the command with arguments as a shell splits them.
  Result run(const std::string& arguments) const { return shell("\"$discmc\" " + arguments); }

  /// Likewise for a run that must succeed. Returns its standard output.
  std::string done(const std::string& arguments) const {
    const Result result = run(arguments);
    INFO(arguments, "\n", result.error);
    REQUIRE(result.code == 0);
    return result.out;
  }

  /// Likewise for a run that must fail. It prints all parts on standard error and nothing on
  /// standard output, and leaves no file.
  void fails(const std::string& arguments, int code, const std::vector<std::string>& parts) const {
    const std::vector<std::string> before = file_names();
    const Result result = run(arguments);
    INFO(arguments, "\n", result.error);
    CHECK(result.code == code);
    CHECK(result.out.empty());
    for (const std::string& part : parts) CHECK(contains(result.error, part));
    CHECK(file_names() == before);
  }

  bool has_program(const std::string& name) const { return shell("command -v " + name).code == 0; }

  /// The lines of `info` by their keys.
  std::map<std::string, std::string> info_of(const std::string& stream) const {
    std::map<std::string, std::string> values;
    std::istringstream lines(run("info " + stream).out);
    for (std::string line; std::getline(lines, line);)
      values[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
    return values;
  }

  void write(const std::string& name, const std::string& bytes) const {
    folder_.write(name, bytes);
  }

  /// Writes the volume as an NRRD file with additional header lines. On is 200, off is 10.
  void write(const std::string& name, const BitVolume& volume,
             const std::string& lines = "spacings: 1 1 1\n" + volume_files::units_in_mm) const {
    std::string samples;
    for (const std::uint8_t on : volume.on) samples += static_cast<char>(on != 0 ? 200 : 10);
    const std::string sizes = std::to_string(volume.width) + " " + std::to_string(volume.height) +
                              " " + std::to_string(volume.depth);
    write(name, volume_files::nrrd(volume_files::nrrd_u8 + lines, sizes) + "\n" + samples);
  }

  std::string read(const std::string& name) const { return contents(folder_.path() / name); }
  FileMesh mesh_in(const std::string& name) const { return mesh_of(name, read(name)); }
  /// Reads all meshes of GLB or 3MF.
  std::vector<FileMesh> meshes_in(const std::string& name) const {
    const bool is_glb = name.substr(name.size() - 4) == ".glb";
    return is_glb ? meshes_of_glb(read(name)) : meshes_of_3mf(read(name));
  }

  /// The names of all files, sorted.
  std::vector<std::string> file_names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  volume_files::Folder folder_;
  volume_files::Folder logs_;
};

// ---- meshes ----

inline void add_face(FileMesh& mesh, const std::vector<std::uint32_t>& corners) {
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  mesh.face_begin.push_back(mesh.corners.size());
  mesh.incidences.push_back(0);
}

inline FileMesh mesh_of_obj(const std::string& text) {
  FileMesh mesh;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v" || key == "vn") {
      Point point{};
      words >> point[0] >> point[1] >> point[2];
      (key == "v" ? mesh.vertices_mm : mesh.normals).push_back(point);
    } else if (key != "f") {
      CHECK((key == "#" || key == "o" || key == "mtllib" || key == "usemtl"));
    } else {
      std::vector<std::uint32_t> face;
      for (std::string corner; words >> corner;) {
        const std::size_t slashes = corner.find("//");
        const std::string number = corner.substr(0, slashes);
        CHECK((slashes == std::string::npos) == mesh.normals.empty());
        if (slashes != std::string::npos) CHECK(corner.substr(slashes + 2) == number);
        face.push_back(static_cast<std::uint32_t>(std::stoul(number)) - 1);
      }
      add_face(mesh, face);
    }
  }
  return mesh;
}

/// Reads little-endian values from the front of bytes. Errors: fails the test at the end.
class Taker {
 public:
  explicit Taker(const std::string& bytes, std::size_t at = 0) : bytes_(bytes), at_(at) {}
  std::uint32_t integer(std::size_t size) {
    REQUIRE(at_ + size <= bytes_.size());
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value |= std::uint32_t{static_cast<unsigned char>(bytes_[at_++])} << 8 * i;
    return value;
  }
  /// With samples of 32-bit floats.
  Point point() {
    Point point{};
    for (double& coordinate : point) {
      const std::uint32_t bits = integer(4);
      float value = 0;
      std::memcpy(&value, &bits, sizeof value);
      coordinate = static_cast<double>(value);
    }
    return point;
  }
  Point point_of_doubles() {
    Point point{};
    for (double& coordinate : point) {
      const std::uint64_t low = integer(4);
      const std::uint64_t bits = std::uint64_t{integer(4)} << 32 | low;
      std::memcpy(&coordinate, &bits, sizeof coordinate);
    }
    return point;
  }
  discmc::command::Srgb colour() {
    discmc::command::Srgb colour{};
    for (std::uint8_t& part : colour) part = static_cast<std::uint8_t>(integer(1));
    return colour;
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

inline FileMesh mesh_of_stl(const std::string& bytes) {
  FileMesh mesh;
  std::map<Point, std::uint32_t> numbers;
  Taker taker(bytes, 80);
  for (std::uint32_t left = taker.integer(4); left > 0; --left) {
    taker.point();  // the normal
    std::vector<std::uint32_t> face;
    for (int i = 0; i < 3; ++i) {
      const Point point = taker.point();
      const auto next = static_cast<std::uint32_t>(mesh.vertices_mm.size());
      const auto [entry, is_new] = numbers.try_emplace(point, next);
      if (is_new) mesh.vertices_mm.push_back(point);
      face.push_back(entry->second);
    }
    add_face(mesh, face);
    taker.integer(2);
  }
  CHECK(taker.at_end());
  return mesh;
}

inline std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

inline std::size_t count_after(const std::string& text, const std::string& key) {
  REQUIRE(contains(text, key));
  return std::stoul(text.substr(text.find(key) + key.size()));
}

inline FileMesh mesh_of_ply(const std::string& bytes) {
  const std::string end = "end_header\n";
  REQUIRE(contains(bytes, end));
  const std::size_t body = bytes.find(end) + end.size();
  const std::string header = bytes.substr(0, body);
  const std::string normals = "\nproperty float nx\nproperty float ny\nproperty float nz\n";
  const std::string colour = "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  const bool has_doubles =
      contains(header, "\nproperty double x\nproperty double y\nproperty double z\n");
  FileMesh mesh;
  Taker taker(bytes, body);
  for (std::size_t left = count_after(header, "element vertex "); left > 0; --left) {
    mesh.vertices_mm.push_back(has_doubles ? taker.point_of_doubles() : taker.point());
    if (contains(header, normals)) mesh.normals.push_back(taker.point());
    if (contains(header, colour)) mesh.colour = taker.colour();
  }
  for (std::size_t left = count_after(header, "element face "); left > 0; --left) {
    std::vector<std::uint32_t> face(taker.integer(1));
    for (std::uint32_t& number : face) number = taker.integer(4);
    add_face(mesh, face);
  }
  CHECK(taker.at_end());
  return mesh;
}

/// Reads the format that the extension of the name selects.
inline FileMesh mesh_of(const std::string& name, const std::string& bytes) {
  const std::string extension = name.substr(name.size() - 4);
  if (extension == ".obj") return mesh_of_obj(bytes);
  if (extension == ".glb") return mesh_of_glb(bytes);
  if (extension == ".3mf") return mesh_of_3mf(bytes);
  if (extension == ".vtp") return mesh_of_vtp(bytes);
  return extension == ".ply" ? mesh_of_ply(bytes) : mesh_of_stl(bytes);
}

/// The volume inside the faces, if they are closed and face outwards. Units: cubic millimetres.
inline double volume_of(const FileMesh& mesh) {
  double sum = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (std::size_t i = 2; i < mesh.face_size(face); ++i) {
      const Point& a = mesh.vertices_mm[mesh.face(face)[0]];
      const Point& b = mesh.vertices_mm[mesh.face(face)[i - 1]];
      const Point& c = mesh.vertices_mm[mesh.face(face)[i]];
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  return sum / 6;
}

/// Checks that the command prints all of these on standard error.
inline void check_parts(const Result& result, int code, const std::vector<std::string>& parts) {
  INFO(result.error);
  CHECK(result.code == code);
  for (const std::string& part : parts) CHECK(contains(result.error, part));
}

/// Likewise, and nothing on standard output.
inline void check_failure(const Result& result, int code, const std::vector<std::string>& parts) {
  check_parts(result, code, parts);
  CHECK(result.out.empty());
}

}  // namespace command_tests
