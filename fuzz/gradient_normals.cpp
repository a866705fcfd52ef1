// Fuzz target. A scan with normals sends the same surface as a scan without, for any missing rows,
// memory and sink. Every normal is that of a second pass.
//
//   fuzz_gradient_normals -max_len=400 corpus/gradient_normals    with libFuzzer
//   fuzz_gradient_normals corpus/gradient_normals                 with replay_main.cpp
#include <algorithm>
#include <memory>

#include "input.hpp"
#include "little_memory.hpp"
#include "oracle/normal_events.hpp"
#include "require.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::SampleVolume;

namespace {

struct Setting {
  Limits limits;
  int32_t threshold;
  Capacities capacities;
  bool refuses;
};

enum class Row : uint8_t { given, off, repeated };

// The actions for the rows of a volume, one after another.
struct Script {
  std::vector<Row> rows;
  uint32_t portion;  // of samples
  bool abandons;     // after some samples of one more row
  bool is_whole() const {
    for (const Row row : rows)
      if (row != Row::given) return false;
    return !abandons;
  }
};

// Throws on errors, which none of the scripts should cause.
template <class Scan>
void resume(Scan& scan, Status status) {
  while (status == Status::suspended) status = scan.resume();
  require(status == Status::ok, to_string(status));
}

template <class Scan, class Sample>
void push(Scan& scan, const Sample* samples, uint32_t count, uint32_t portion) {
  for (uint32_t at = 0; at < count;) {
    const PushResult pushed = scan.push(samples + at, std::min(portion, count - at));
    at += pushed.samples;
    resume(scan, pushed.status);
  }
}

template <class Normals, class Sample>
Events events_of(const SampleVolume<Sample>& volume, const Setting& setting, const Script& script) {
  using Scan = typename ExtractorOf<uint16_t, Normals>::Type;
  const size_t bytes =
      detail::sizing::bytes_for<uint16_t, Normals>(setting.limits, setting.capacities);
  const std::unique_ptr<uint8_t[]> memory(new uint8_t[bytes]);
  EventLog log(setting.refuses ? EventLog::Refuses(reference::refuses_first) : nullptr);
  Scan scan;
  if constexpr (Normals::holds_samples) scan.set_spacing(uneven_spacing);
  resume(scan, scan.start(setting.limits, setting.capacities, setting.threshold,
                          {memory.get(), bytes}, make_sink(log)));
  const uint32_t width = setting.limits.width;
  const Sample* samples = volume.samples.data();
  for (const Row row : script.rows) {
    if (row == Row::given)
      push(scan, samples, width, script.portion);
    else
      resume(scan,
             scan.skip_row(row == Row::off ? Substitute::off : Substitute::previous_row).status);
    samples += width;
  }
  if (script.abandons) {
    push(scan, volume.samples.data(), width / 2, script.portion);
    resume(scan, scan.abandon());
  } else {
    resume(scan, scan.finish());
  }
  return log.events;
}

template <class Sample>
void check(const SampleVolume<Sample>& volume, const Setting& setting, const Script& script) {
  const Events events = events_of<detail::trace::GradientIntake<Sample>>(volume, setting, script);
  require(without_normals(events) == events_of<detail::trace::BitIntake>(volume, setting, script),
          "normals change the events");
  if (!script.is_whole()) return;
  for_each_start(events, [&](const Vertex& vertex, OctahedralNormal normal, bool is_corner) {
    if (normal.is_none() && !is_corner) return;
    require(normal == reference_normal(volume, vertex), "a normal is not that of a second pass");
  });
}

template <class Sample>
void read_and_check(Input& input) {
  const reference::Size size{1 + input.below(10), 1 + input.below(6), 1 + input.below(6)};
  const uint32_t flags = input.byte();
  const Border border = (flags & 1) != 0 ? Border::open : Border::closed;
  const Capacities capacities = read_little_memory(input);
  const int32_t threshold = static_cast<int32_t>(input.byte()) - 2;
  const Setting setting{{size.width, size.height, border}, threshold, capacities, (flags & 4) != 0};
  Script script{{}, 1 + input.below(12), (flags & 8) != 0};
  const uint32_t rows = size.height * size.depth;
  const uint32_t given = script.abandons ? input.below(rows) : rows;
  for (uint32_t row = 0; row < given; ++row) {
    const uint32_t kind = (flags & 16) != 0 ? input.below(5) : 2;
    script.rows.push_back(kind == 0 ? Row::off : kind == 1 ? Row::repeated : Row::given);
  }
  SampleVolume<Sample> volume{size, {}};
  for (uint32_t i = 0; i < rows * size.width; ++i)
    volume.samples.push_back(static_cast<Sample>(input.byte()));
  check(volume, setting, script);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  switch (input.below(3)) {
    case 0:
      read_and_check<uint8_t>(input);
      break;
    case 1:
      read_and_check<uint16_t>(input);
      break;
    default:
      read_and_check<int16_t>(input);
      break;
  }
  return 0;
}
