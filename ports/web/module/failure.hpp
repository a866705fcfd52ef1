// What is thrown here the page catches: there is no unwinding in the module.
#pragma once

namespace discmc::web {

/// Calls, and returns whether nothing was thrown. The stack is then dropped;
/// no destructor runs.
bool attempt(void (*call)(void* context), void* context);

template <class Call>
bool succeeds(Call call) {
  return attempt([](void* context) { (*static_cast<Call*>(context))(); }, &call);
}

}  // namespace discmc::web
