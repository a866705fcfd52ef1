// A program may use the whole namespace together with short names of its own.
#include <discmc/discmc.h>

#include <discmc/discmc.hpp>

#include "test.hpp"

static int slices = 1, stream = 2, trace = 3, join = 4, wire = 5, links = 6, move = 7, add = 8,
           dot = 9, normal = 10, derive = 11, sizing = 12, BitIntake = 13, GradientIntake = 14,
           RowOrigin = 15, NoNormal = 16, SampleRows = 17, PacketReader = 18, PacketWriter = 19;

using namespace discmc;

TEST_CASE("using namespace discmc does not make common names, or internal ones, ambiguous") {
  CHECK(slices + stream + trace + join + wire + links + move + add + dot + normal + derive +
            sizing ==
        78);
  CHECK(BitIntake + GradientIntake + RowOrigin + NoNormal + SampleRows + PacketReader +
            PacketWriter ==
        112);
}
