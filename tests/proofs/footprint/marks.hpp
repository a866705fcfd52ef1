// Marks for the plugin. It adds up the instructions between the marks `on` and `off`. At the mark
// `report` it prints the sum and resets it.
#pragma once

extern "C" {
void count_on();
void count_off();
void count_report();
}
