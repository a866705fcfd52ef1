// Exceptions of the module, caught by the page: the module cannot unwind the stack.
#pragma once

namespace discmc::web {

/// Calls the function. Returns whether it threw nothing. After a throw the stack is dropped; no
/// destructor runs.
bool attempt(void (*call)(void* context), void* context);

template <class Call>
bool succeeds(Call call) {
  return attempt([](void* context) { (*static_cast<Call*>(context))(); }, &call);
}

}  // namespace discmc::web
