// Loops over all incidences.
#pragma once

#include <discmc/lattice.hpp>

#include "test.hpp"

namespace discmc::test {

template <class Check>
void for_each_incidence(Check check) {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (incidence == no_incidence) continue;
    CAPTURE(int{incidence});
    check(incidence);
  }
}

}  // namespace discmc::test
