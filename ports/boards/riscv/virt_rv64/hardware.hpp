#include "../virt_rv32/hardware.hpp"
