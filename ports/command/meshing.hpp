// The command is written in the terms of the mesh library.
#ifndef DISCMC_COMMAND_MESHING_HPP
#define DISCMC_COMMAND_MESHING_HPP

namespace discmc::meshing {}

namespace discmc::command {
using namespace meshing;
}

#endif
