// discmc.h in terms of the C++ library: several surfaces of a scan. A file of its own, so that
// scanners with one do not link it.
#include <discmc/discmc.h>

#include <discmc/c_extractors.hpp>
#include <discmc/surface_group.hpp>

namespace discmc {

namespace {

// An extractor in an array of C's.
struct GroupScanner {
  discmc_extractor storage;

  Extractor16& extractor() { return reinterpret_cast<SinkAdapter<Extractor16>*>(this)->object; }
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride) {
    return extractor().push(samples, count, stride);
  }
  PushResult push_bits(const uint8_t* bits) { return extractor().push_bits(bits); }
  PushResult skip_row(Substitute substitute) { return extractor().skip_row(substitute); }
  Status resume() { return extractor().resume(); }
  Status finish() { return extractor().finish(); }
  Status abandon() { return extractor().abandon(); }
};

struct Group : SurfaceGroup<GroupScanner> {
  using SurfaceGroup::SurfaceGroup;
  static void* operator new(size_t, void* place) { return place; }
};

// In storage of C's. Zeros are none that was started.
struct StoredGroup {
  uint32_t is_started;
  Group group;
};
static_assert(has_alignment<StoredGroup, discmc_surface_group> &&
                  sizeof(StoredGroup) <= sizeof(discmc_surface_group) &&
                  sizeof(discmc_surface_group) < sizeof(StoredGroup) + sizeof(uint64_t),
              "the size in discmc.h is enough");

template <class Call>
discmc_push_result push_to(discmc_surface_group* group, Call call) {
  StoredGroup& stored = *reinterpret_cast<StoredGroup*>(group);
  if (stored.is_started == 0) return {DISCMC_NOT_STARTED, 0};
  return c(call(stored.group));
}
template <Status (SurfaceGroup<GroupScanner>::*method)()>
discmc_status call_all(discmc_surface_group* group) {
  StoredGroup& stored = *reinterpret_cast<StoredGroup*>(group);
  return stored.is_started == 0 ? discmc_status{DISCMC_NOT_STARTED} : c((stored.group.*method)());
}

}  // namespace

extern "C" {

void discmc_surface_group_start(discmc_surface_group* group, discmc_extractor* extractors,
                                uint32_t count, uint32_t width) {
  StoredGroup& stored = *reinterpret_cast<StoredGroup*>(group);
  stored.is_started = 1;
  new (&stored.group) Group(reinterpret_cast<GroupScanner*>(extractors), count, width);
}
discmc_push_result discmc_surface_group_push_u8(discmc_surface_group* group, const uint8_t* samples,
                                                uint32_t count, uint32_t stride) {
  return push_to(group, [=](Group& all) { return all.push(samples, count, stride); });
}
discmc_push_result discmc_surface_group_push_u16(discmc_surface_group* group,
                                                 const uint16_t* samples, uint32_t count,
                                                 uint32_t stride) {
  return push_to(group, [=](Group& all) { return all.push(samples, count, stride); });
}
discmc_push_result discmc_surface_group_push_i16(discmc_surface_group* group,
                                                 const int16_t* samples, uint32_t count,
                                                 uint32_t stride) {
  return push_to(group, [=](Group& all) { return all.push(samples, count, stride); });
}
discmc_push_result discmc_surface_group_push_bits(discmc_surface_group* group,
                                                  const uint8_t* bits) {
  return push_to(group, [=](Group& all) { return all.push_bits(bits); });
}
discmc_push_result discmc_surface_group_skip_row(discmc_surface_group* group, uint8_t substitute) {
  return push_to(group,
                 [=](Group& all) { return all.skip_row(static_cast<Substitute>(substitute)); });
}
discmc_status discmc_surface_group_resume(discmc_surface_group* group) {
  return call_all<&SurfaceGroup<GroupScanner>::resume>(group);
}
discmc_status discmc_surface_group_finish(discmc_surface_group* group) {
  return call_all<&SurfaceGroup<GroupScanner>::finish>(group);
}
discmc_status discmc_surface_group_abandon(discmc_surface_group* group) {
  return call_all<&SurfaceGroup<GroupScanner>::abandon>(group);
}

}  // extern "C"

}  // namespace discmc
