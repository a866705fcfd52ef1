// The marks that the plugin looks for: the instructions between on and off are added up, and at
// tell the sum is told and begins anew.
#ifndef DISCMC_TESTS_FOOTPRINT_MARKS_HPP
#define DISCMC_TESTS_FOOTPRINT_MARKS_HPP

extern "C" {
void count_on();
void count_off();
void count_tell();
}

#endif
