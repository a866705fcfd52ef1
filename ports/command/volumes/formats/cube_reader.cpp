// Gaussian cube, https://gaussian.com/cubegen/: numbers as text, with z fastest.
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

#include "text/words.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

// A count, and the three numbers behind it.
struct CountedVector {
  std::int64_t count = 0;
  std::array<double, 3> vector{};
};

CountedVector counted_vector(ByteStream& stream) {
  const std::string line = stream.read_line().value_or("");
  const auto parts = words(line);
  if (parts.size() < 4)
    fail(stream.file(), "the header line " + shown(line) + " has no count and three numbers",
         "check that it is a Gaussian cube");
  if (parts.size() > 4 && parts[4] != "1")
    fail(stream.file(), "a voxel has " + shown(parts[4]) + " numbers", "write one to a file");
  CountedVector read{integer(stream.file(), "a count", parts[0])};
  for (std::size_t i = 0; i < 3; ++i)
    read.vector[i] = real(stream.file(), "a vector", parts[i + 1]);
  return read;
}

}  // namespace

std::unique_ptr<VolumeReader> open_cube(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  stream.skip_lines(2);
  const CountedVector atoms = counted_vector(stream);
  std::array<CountedVector, 3> axes;
  for (CountedVector& axis : axes) axis = counted_vector(stream);
  constexpr std::int64_t max_atoms = 1 << 24;
  if (std::llabs(atoms.count) > max_atoms)
    fail(file, std::to_string(atoms.count) + " atoms are too many", "correct the header");
  stream.skip_lines(static_cast<std::uint64_t>(std::llabs(atoms.count)));
  if (atoms.count < 0) {  // of a list of orbitals, which follows
    const std::string orbitals = stream.read_line().value_or("");
    if (words(orbitals).size() != 2)
      fail(file, "the orbitals are " + shown(orbitals), "write one orbital to a file");
  }
  VolumeInfo info;
  info.format = "Gaussian cube";
  info.type = SampleType::f32;
  const double angstrom = axes[0].count < 0 ? 1 : 0.529177210903;
  ArrayShape shape{{}, "xyz"};
  DeclaredPlace place;
  place.set_unit("mm");
  place.steps.emplace();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shape.sizes.push_back(std::llabs(axes[axis].count));
    for (std::size_t i = 0; i < 3; ++i) (*place.steps)[axis][i] = axes[axis].vector[i] * angstrom;
    place.origin[axis] = atoms.vector[axis] * angstrom;
  }
  note(info, "lengths are converted to angstrom; 1 angstrom is written as 1 mm");
  const ArrayLayout layout = find_volume_axes(info, file, shape, options);
  set_place(info, place, options);
  stream.decode([](auto in) { return samples_of_text(std::move(in), SampleType::f32); });
  return array_volume(std::move(info), std::move(stream), layout, is_native_big_endian());
}

}  // namespace discmc::command
