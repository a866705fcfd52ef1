// Rows from a host, over a second UART of the kind in uart/cmsdk.cpp. README.md describes the
// protocol.
#include <hardware.hpp>
#include <scan.hpp>

#include "board.hpp"
#include "port.hpp"
#include "row_receiver.hpp"

namespace {

constexpr uintptr_t data = hardware::rows_uart, state = data + 4, control = data + 8,
                    interrupts = data + 12, divider = data + 16;
constexpr uint32_t is_full = 1, has_received = 2;          // of the state
constexpr uint32_t all_enabled = 1 | 2 | 1 << 2 | 1 << 3;  // of the control
constexpr uint32_t sent_and_received = 1 | 2;              // of the interrupts

constexpr size_t row_bytes = scan::limits.width * sizeof(scan::Sample);
static_assert(row_bytes <= row_frame::max_samples, "a row has to fit a frame");

RowReceiver receiver(row_bytes);

// Messages to the host that have not been sent. The main loop writes the first one, the interrupts
// write all others.
uint32_t rows_emptied = 0;
uint32_t rows_reported = 0;
uint32_t frames_dropped = 0;
bool start_is_accepted = false;
bool start_is_refused = false;

// Returns the next answer that is due; false if there is none.
bool next_answer(row_frame::Answer& answer) {
  if (start_is_accepted) {
    start_is_accepted = false;
    answer = row_frame::Answer::ready;
  } else if (start_is_refused) {
    start_is_refused = false;
    answer = row_frame::Answer::refused;
  } else if (rows_reported != __atomic_load_n(&rows_emptied, __ATOMIC_RELAXED)) {
    ++rows_reported;
    answer = row_frame::Answer::taken;
  } else if (frames_dropped > 0) {
    --frames_dropped;
    answer = row_frame::Answer::dropped;
  } else {
    return false;
  }
  return true;
}

// The rest follows when the UART interrupts after sending a byte.
void answer_host() {
  row_frame::Answer answer;
  while (!(register_at(state) & is_full) && next_answer(answer))
    register_at(data) = static_cast<uint32_t>(answer);
}

void receive(uint8_t byte) {
  switch (receiver.accept(byte, rows::free_row())) {
    case RowReceiver::Event::nothing:
      break;
    case RowReceiver::Event::start:
      start_is_accepted = true;
      break;
    case RowReceiver::Event::refused:
      start_is_refused = true;
      break;
    case RowReceiver::Event::row:
      rows::row_is_full(receiver.number());
      break;
    case RowReceiver::Event::end:
      rows::end_of_scan(receiver.number(), false);
      break;
    case RowReceiver::Event::broken_off:
      rows::end_of_scan(receiver.number(), true);
      break;
    case RowReceiver::Event::dropped:
      ++frames_dropped;
      break;
  }
}

}  // namespace

void source::start() {
  register_at(divider) = hardware::uart_divider;
  register_at(control) = all_enabled;
  register_at(data) = static_cast<uint32_t>(row_frame::Answer::restarted);
  cpu::enable_interrupt(hardware::rows_send_interrupt);
  cpu::enable_interrupt(hardware::rows_receive_interrupt);
}

void board::row_is_free() {
  __atomic_store_n(&rows_emptied, rows_emptied + 1, __ATOMIC_RELAXED);
  cpu::request_rows();
}

void source::on_request() {
  answer_host();
}

void source::on_interrupt() {
  register_at(interrupts) = sent_and_received;
  if (register_at(state) & has_received) receive(static_cast<uint8_t>(register_at(data)));
  answer_host();
}
