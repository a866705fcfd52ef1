// Flash: a joiner, with a sink that throws everything away.
#include <discmc/joiner.hpp>

using namespace discmc;

static Answer take(void*, const Event&) {
  return Answer::taken;
}

extern "C" Status run(Joiner& joiner, Memory memory, const Event& event) {
  Status status = joiner.start(memory, {nullptr, take}, InputOrder::sweep);
  if (status == Status::ok && joiner.take(event) == Answer::not_now) status = Status::more;
  return status == Status::ok ? joiner.finish() : status;
}
