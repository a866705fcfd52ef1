#include "../virt_rv32/scan.hpp"
