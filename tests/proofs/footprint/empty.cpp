// Flash: nothing, which the other programs are compared with.
extern "C" void run() {}
