// Values as text.
#ifndef DISCMC_COMMAND_TEXT_VALUE_TEXT_HPP
#define DISCMC_COMMAND_TEXT_VALUE_TEXT_HPP

#include <string>

namespace discmc::command {

/// The value in decimal, in 15 digits at most, without zeros at the end. What came from 32 bits of
/// floating point has the digits of these: 0.1, not 0.100000001490116.
std::string value_text(double value);

}  // namespace discmc::command

#endif
