// What discmc extract does, by what it writes.
#ifndef DISCMC_COMMAND_COMMANDS_EXTRACT_HPP
#define DISCMC_COMMAND_COMMANDS_EXTRACT_HPP

#include <memory>
#include <vector>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "surface_receiver.hpp"

namespace discmc::host {

/// Each writes its files, then the table, and returns the exit code.
int extract_stream(const ExtractArguments& arguments);
int extract_meshes(const ExtractArguments& arguments);

/// One a surface, in the order of the selections.
using SurfaceReceivers = std::vector<std::unique_ptr<SurfaceReceiver>>;

SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections);
std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers);

/// Says how many samples are not a number, if any.
void note_not_numbers(const ExtractArguments& arguments, const Extraction& extraction);

}  // namespace discmc::host

#endif
