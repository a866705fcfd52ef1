// Replaces the readers that are in modules: loads each module at its first call. Starting all their
// libraries takes longer than extracting a small volume.
#include <dlfcn.h>

#include <string>

#include "mesh_files/mesh_reader.hpp"
#include "volumes/formats/pictures/picture_file.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// file: the file to read.
template <class Reader>
Reader* load(const std::string& module, const std::string& file) {
  // The RUNPATH of the program names the folder of modules. Plugins of HDF5 may need the module's
  // functions to be global.
  void* const loaded = dlopen((module + ".so").c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* const reader = loaded == nullptr ? nullptr : dlsym(loaded, module.c_str());
  if (reader == nullptr)
    fail(file, std::string("the reader cannot be loaded (") + dlerror() + ")",
         "install discmc again, with its folder lib/discmc");
  return *static_cast<Reader**>(reader);
}

}  // namespace

#ifdef DISCMC_MODULE_DICOM
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes) {
  static const auto reader = load<decltype(open_dicom)>(DISCMC_MODULE_DICOM, source);
  return reader(source, files, options, notes);
}
#endif

#ifdef DISCMC_MODULE_HDF5
std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options) {
  static const auto reader = load<decltype(open_hdf5)>(DISCMC_MODULE_HDF5, name);
  return reader(name, options);
}
#endif

#ifdef DISCMC_MODULE_TIFF
std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file) {
  static const auto reader = load<decltype(open_tiff)>(DISCMC_MODULE_TIFF, file);
  return reader(file);
}
#endif

#ifdef DISCMC_MODULE_MESHES
std::vector<FileMesh> read_meshes(const std::string& file) {
  static const auto reader = load<decltype(read_meshes)>(DISCMC_MODULE_MESHES, file);
  return reader(file);
}
#endif

}  // namespace discmc::command
