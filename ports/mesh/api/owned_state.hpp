// The state of a movable object.
#ifndef DISCMC_MESH_API_OWNED_STATE_HPP
#define DISCMC_MESH_API_OWNED_STATE_HPP

#include <memory>
#include <stdexcept>

namespace discmc::meshing {

/// Throws std::logic_error with the message if there is no state.
template <class State>
State& require_state(const std::unique_ptr<State>& state, const char* message) {
  if (!state) throw std::logic_error(message);
  return *state;
}

}  // namespace discmc::meshing

#endif
