// Reads and writes volumes by ITK, for compare.py. Samples pass through raw files in the byte order
// of this machine.
#include <itkImageIOBase.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVTKImageIO.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Io = itk::ImageIOBase;

constexpr const char* usage =
    "usage: itk_image read VOLUME RAW\n"
    "       itk_image write RAW VOLUME TYPE COMPRESSED WIDTH HEIGHT DEPTH SPACING(3) ORIGIN(3) "
    "DIRECTIONS(9)\n";

Io::Pointer io_of(const std::string& file) {
  const Io::Pointer all[] = {
      itk::NrrdImageIO::New().GetPointer(), itk::MetaImageIO::New().GetPointer(),
      itk::NiftiImageIO::New().GetPointer(), itk::VTKImageIO::New().GetPointer()};
  for (const Io::Pointer& io : all)
    if (io->CanWriteFile(file.c_str())) return io;
  throw std::invalid_argument(file + ": no format of ITK is known for it");
}

// Reads or writes everything at once.
void read_all(Io& io) {
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis)
    region.SetSize(axis, io.GetDimensions(axis));
  io.SetIORegion(region);
}

void print(const char* name, const std::vector<double>& numbers) {
  std::cout << '"' << name << "\": [";
  for (std::size_t i = 0; i < numbers.size(); ++i) std::cout << (i > 0 ? ", " : "") << numbers[i];
  std::cout << "], ";
}

void read(const std::string& file, const std::string& raw) {
  const Io::Pointer io = io_of(file);
  io->SetFileName(file);
  io->ReadImageInformation();
  read_all(*io);
  std::vector<char> samples(static_cast<std::size_t>(io->GetImageSizeInBytes()));
  io->Read(samples.data());
  std::ofstream(raw, std::ios::binary)
      .write(samples.data(), static_cast<std::streamsize>(samples.size()));

  std::vector<double> dims, spacing, origin, directions;
  for (unsigned axis = 0; axis < io->GetNumberOfDimensions(); ++axis) {
    dims.push_back(static_cast<double>(io->GetDimensions(axis)));
    spacing.push_back(io->GetSpacing(axis));
    origin.push_back(io->GetOrigin(axis));
    for (const double each : io->GetDirection(axis)) directions.push_back(each);
  }
  std::cout << std::setprecision(17) << '{';
  print("dims", dims);
  print("spacing", spacing);
  print("origin", origin);
  print("directions", directions);
  std::cout << "\"type\": \"" << Io::GetComponentTypeAsString(io->GetComponentType()) << "\"}\n";
}

void write(const std::vector<std::string>& words) {
  const std::string& file = words.at(1);
  const Io::Pointer io = io_of(file);
  const auto number = [&words](std::size_t place) { return std::stod(words.at(place)); };
  io->SetNumberOfDimensions(3);
  for (unsigned axis = 0; axis < 3; ++axis) {
    io->SetDimensions(axis, static_cast<itk::SizeValueType>(number(4 + axis)));
    io->SetSpacing(axis, number(7 + axis));
    io->SetOrigin(axis, number(10 + axis));
    const std::size_t first = 13 + 3 * std::size_t{axis};
    io->SetDirection(axis,
                     std::vector<double>{number(first), number(first + 1), number(first + 2)});
  }
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetComponentType(Io::GetComponentTypeFromString(words.at(2)));
  io->SetUseCompression(words.at(3) == "1");
  io->SetFileName(file);
  read_all(*io);
  std::ifstream raw(words.at(0), std::ios::binary);
  const std::vector<char> samples{std::istreambuf_iterator<char>(raw), {}};
  if (samples.size() != static_cast<std::size_t>(io->GetImageSizeInBytes()))
    throw std::invalid_argument(words.at(0) + ": not as many bytes as samples");
  io->WriteImageInformation();
  io->Write(samples.data());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 3 && words[0] == "read") {
      read(words[1], words[2]);
      return EXIT_SUCCESS;
    }
    if (words.size() == 23 && words[0] == "write") {
      write({words.begin() + 1, words.end()});
      return EXIT_SUCCESS;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cerr << usage;
  return EXIT_FAILURE;
}
