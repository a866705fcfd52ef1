// Exports the reader DISCMC_READER of the module DISCMC_MODULE under a name of its own. Names must
// differ because all modules are loaded as global, and sanitizers reject two variables of one name.
#include "mesh_files/mesh_reader.hpp"
#include "volumes/formats/pictures/picture_file.hpp"
#include "volumes/formats/readers.hpp"

extern "C" {
auto* DISCMC_MODULE = &discmc::command::DISCMC_READER;
}
