// A pool of records with a free list through their own `next` member.
#ifndef DISCMC_POOL_HPP
#define DISCMC_POOL_HPP

#include <stdint.h>

namespace discmc {

/// Records named by index. Which index a record gets depends on nothing but the order of the calls.
/// Owner: the records lie in the arena. Cost of take() and give(): a few instructions.
template <class Record, class Index>
class Pool {
 public:
  static constexpr Index none = static_cast<Index>(~Index{0});

  void start(Record* records, uint32_t capacity) {
    records_ = records;
    capacity_ = capacity;
    clear();
  }

  /// Gives all records back at once and forgets the high-water mark.
  void clear() {
    free_ = none;
    fresh_ = 0;
    in_use_ = 0;
    high_water_ = 0;
  }

  /// A record, its members undefined, or `none` when all are in use.
  Index take() {
    if (free_ == none && fresh_ == capacity_) return none;
    if (++in_use_ > high_water_) high_water_ = in_use_;
    if (free_ == none) return static_cast<Index>(fresh_++);
    const Index index = free_;
    free_ = records_[index].next;
    return index;
  }

  void give(Index index) {
    records_[index].next = free_;
    free_ = index;
    --in_use_;
  }

  Record& operator[](Index index) { return records_[index]; }
  const Record& operator[](Index index) const { return records_[index]; }

  uint32_t capacity() const { return capacity_; }
  uint32_t in_use() const { return in_use_; }
  uint32_t available() const { return capacity_ - in_use_; }
  uint32_t high_water() const { return high_water_; }

 private:
  Record* records_ = nullptr;
  uint32_t capacity_ = 0;
  uint32_t fresh_ = 0;  // records from here on have never been taken
  uint32_t in_use_ = 0;
  uint32_t high_water_ = 0;
  Index free_ = none;
};

}  // namespace discmc

#endif
