// The marks for the plugin: it adds up the instructions between on and off, and at the mark
// `report` prints the sum and resets it.
#pragma once

extern "C" {
void count_on();
void count_off();
void count_report();
}
