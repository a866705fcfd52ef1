// No rows arrive: for applications that make their own.
#include "port.hpp"

void source::start() {}
void source::on_request() {}
void source::on_interrupt() {}
