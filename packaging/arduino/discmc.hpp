// The Arduino build looks for the headers of a library in its top folder alone.
#include <discmc/discmc.hpp>
