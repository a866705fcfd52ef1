// What a module exports: its reader, whose name is DISCMC_READER.
#include "mesh_files/mesh_reader.hpp"
#include "volumes/formats/readers.hpp"

extern "C" {
auto* discmc_reader = &discmc::command::DISCMC_READER;
}
