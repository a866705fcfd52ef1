#include "failure.hpp"

#include <cstddef>
#include <cstdlib>
#include <exception>

// A function of the page: page/module.js.
__attribute__((import_module("page"), import_name("fail"))) extern "C" [[noreturn]] void page_fail(
    const char* text);
__attribute__((import_module("page"), import_name("attempt"))) extern "C" int page_attempt(
    void (*call)(void*), void* context);

// The compiler calls these for a throw. All exceptions are std::exception.
extern "C" void* __cxa_allocate_exception(std::size_t bytes) noexcept {
  return std::malloc(bytes);
}
extern "C" void __cxa_free_exception(void* thrown) noexcept {
  std::free(thrown);
}
extern "C" [[noreturn]] void __cxa_throw(void* thrown, void*, void (*)(void*)) {
  page_fail(static_cast<std::exception*>(thrown)->what());
}

namespace discmc::web {

bool attempt(void (*call)(void*), void* context) {
  return page_attempt(call, context) != 0;
}

}  // namespace discmc::web
