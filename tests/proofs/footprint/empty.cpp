// Flash: an empty program, the baseline of the others.
extern "C" void run() {}
