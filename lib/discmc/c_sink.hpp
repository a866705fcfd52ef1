// What the files of the C API share: objects in storage of C's, and their sinks.
#ifndef DISCMC_C_SINK_HPP
#define DISCMC_C_SINK_HPP

#include <discmc/discmc.h>
#include <discmc/sink.hpp>
#include <discmc/slice_decoder.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// An object that offers its events to a C sink, of which it keeps a copy. The object calls a
/// function of a C++ type, which calls the C function.
template <class Object, class EventOfC = discmc_event>
struct SinkAdapter {
  Object object;
  void* context;
  discmc_answer (*take)(void* context, const EventOfC* event);

  /// start(sink): starts the object. When it fails, the sink of the last start stays.
  template <class SinkOfC, class Start>
  discmc_status start_to(const SinkOfC& sink, Start start) {
    const auto last_context = context;
    const auto last_take = take;
    context = sink.context;
    take = sink.take;
    const Status status = start(passing_to(sink));
    if (status != Status::ok) {
      context = last_context;
      take = last_take;
    }
    return static_cast<discmc_status>(status);
  }

  Sink passing_to(const discmc_sink& sink) {
    return {this, sink.take == nullptr ? nullptr : offer<Event>};
  }
  RowSink passing_to(const discmc_row_sink& sink) {
    return {this, sink.take == nullptr ? nullptr : offer<RowEvent>};
  }

  template <class EventOfCpp>
  static Answer offer(void* adapter, const EventOfCpp& event) {
    const SinkAdapter& to = *static_cast<const SinkAdapter*>(adapter);
    return static_cast<Answer>(to.take(to.context, reinterpret_cast<const EventOfC*>(&event)));
  }
};

/// Whether storage of C's is large enough for an object, and not much larger: objects are smaller
/// where 64-bit integers, of which all storage is made, are aligned to 4 bytes, as on 32-bit x86.
template <class Object, class Storage>
constexpr bool has_size = sizeof(Object) <= sizeof(Storage) &&
                          (sizeof(Storage) <= sizeof(Object) + sizeof(Object) / 10 ||
                           alignof(Storage) < 8);
template <class Object, class Storage>
constexpr bool has_alignment = alignof(Object) <= alignof(Storage);
template <class Object, class Storage>
constexpr bool fits =
    has_size<Object, Storage>&& has_alignment<Object, Storage>&& __is_trivially_copyable(Object);

}  // namespace discmc

#endif
