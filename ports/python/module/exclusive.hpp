// An object that one thread of Python uses at a time, as its calls let other threads run.
#pragma once

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <pybind11/pybind11.h>

namespace discmc::python {

namespace py = pybind11;

/// The base class of such an object.
class Exclusive {
 public:
  /// A use by the calling thread. Waits for other threads without the interpreter, since the user
  /// may need it. Throws std::runtime_error if the same thread uses the object already: a signal's
  /// handler does. Limit: holds the interpreter.
  class Use {
   public:
    explicit Use(const Exclusive& object) : object_(object) {
      const std::thread::id self = std::this_thread::get_id();
      if (object.user_ == self)
        throw std::runtime_error("a call of this object is interrupted by this one");
      {
        const py::gil_scoped_release others_run;
        object.mutex_.lock();
      }
      object.user_ = self;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use() {
      object_.user_ = std::thread::id();
      object_.mutex_.unlock();
    }

   private:
    const Exclusive& object_;
  };

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<std::thread::id> user_{std::thread::id()};
};

/// Returns a function that calls one of an object's class while no other thread uses the object.
template <class Class, class Result, class Base, class... Arguments>
auto exclusive(Result (Base::*function)(Arguments...)) {
  return [function](Class& object, Arguments... arguments) {
    const Exclusive::Use use(object);
    return (object.*function)(arguments...);
  };
}
template <class Class, class Result, class Base, class... Arguments>
auto exclusive(Result (Base::*function)(Arguments...) const) {
  return [function](const Class& object, Arguments... arguments) {
    const Exclusive::Use use(object);
    return (object.*function)(arguments...);
  };
}

}  // namespace discmc::python
