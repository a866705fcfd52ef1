// What the module DISCMC_MODULE exports by its own name: the reader DISCMC_READER. The names differ
// because all modules are loaded as global, and sanitizers reject the same variable twice.
#include "mesh_files/mesh_reader.hpp"
#include "volumes/formats/readers.hpp"

extern "C" {
auto* DISCMC_MODULE = &discmc::command::DISCMC_READER;
}
