// The command is written in the terms of the mesh library.
#pragma once

namespace discmc::meshing {}

namespace discmc::command {
using namespace meshing;
}
