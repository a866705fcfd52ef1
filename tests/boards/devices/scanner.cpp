// Simulates a scanner's HID device by /dev/uhid: sends the rows of a file, one report per
// millisecond, and stores the received stream.
//
//   scanner ROWS ROW_BYTES STREAM BEHAVIOUR...
//
//   lose:N     report N, from 0, is not sent
//   repeat:N   report N is sent twice
//   unplug:N   the device is unplugged before report N
#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <hid/report.hpp>
#include <iterator>
#include <set>
#include <string>
#include <vector>

using discmc::device::Report;
using Kind = Report::Kind;
using Bytes = std::vector<std::uint8_t>;

namespace {

// Vendor-defined: 64 bytes in and 64 bytes out, without report ids.
constexpr std::uint8_t descriptor[] = {
    0x06, 0x00, 0xFF,  // usage page: vendor
    0x09, 0x01,        // usage 1
    0xA1, 0x01,        // application
    0x15, 0x00,        //   from 0
    0x26, 0xFF, 0x00,  //   to 255
    0x75, 0x08,        //   of 8 bits
    0x95, 0x40,        //   64 of them
    0x09, 0x01, 0x81, 0x02, 0x09, 0x01, 0x91, 0x02, 0xC0,
};

[[noreturn]] void fail(const char* what) {
  std::perror(what);
  std::exit(1);
}

class Device {
 public:
  Device() : file_(open("/dev/uhid", O_RDWR)) {
    uhid_event event{};
    event.type = UHID_CREATE2;
    std::strcpy(reinterpret_cast<char*>(event.u.create2.name), "discmc test scanner");
    event.u.create2.rd_size = sizeof descriptor;
    std::memcpy(event.u.create2.rd_data, descriptor, sizeof descriptor);
    event.u.create2.bus = 3;  // USB
    event.u.create2.vendor = 0x1209;
    event.u.create2.product = 0x0001;
    send(event);
  }

  void send_report(const Bytes& report) {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = Report::bytes;
    std::memcpy(event.u.input2.data, report.data(), report.size());
    send(event);
  }

  /// Reads what arrives within a time. Units: milliseconds, -1 for no limit.
  template <class Receive>
  void receive(int timeout, Receive receive_report) {
    pollfd waiting{file_, POLLIN, 0};
    if (poll(&waiting, 1, timeout) != 1) return;
    uhid_event event{};
    if (read(file_, &event, sizeof event) < 0) fail("scanner: read");
    if (event.type != UHID_OUTPUT) return;
    // hidapi's report id is included, which a USB device would not receive.
    const std::size_t id = event.u.output.size == Report::bytes + 1 ? 1 : 0;
    if (const auto report = Report::read(event.u.output.data + id, event.u.output.size - id))
      receive_report(*report);
  }

 private:
  void send(const uhid_event& event) {
    if (write(file_, &event, sizeof event) < 0) fail("scanner: write");
  }

  int file_;
};

std::vector<Bytes> reports_of(const Bytes& samples, std::size_t row_bytes) {
  std::vector<Bytes> reports;
  for (std::size_t row = 0; row * row_bytes < samples.size(); ++row) {
    std::uint16_t chunk = 0;
    for (std::size_t at = 0; at < row_bytes; at += Report::payload_bytes) {
      const std::size_t length = std::min(Report::payload_bytes, row_bytes - at);
      Bytes bytes(Report::bytes);
      Report{Kind::row, static_cast<std::uint8_t>(length), chunk++, static_cast<std::uint32_t>(row),
             &samples[row * row_bytes + at]}
          .write(bytes.data());
      reports.push_back(bytes);
    }
  }
  Bytes end(Report::bytes);
  Report{Kind::end, 0, 0, static_cast<std::uint32_t>(samples.size() / row_bytes), nullptr}.write(
      end.data());
  reports.push_back(end);
  return reports;
}

struct Behaviour {
  std::set<std::size_t> lost, repeated, unplugged;
};

Behaviour behaviour_of(int count, char** arguments) {
  Behaviour behaviour;
  for (int i = 0; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t colon = argument.find(':');
    const std::string what = argument.substr(0, colon);
    auto& reports = what == "lose"     ? behaviour.lost
                    : what == "repeat" ? behaviour.repeated
                                       : behaviour.unplugged;
    reports.insert(static_cast<std::size_t>(std::atol(argument.c_str() + colon + 1)));
  }
  return behaviour;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  std::ifstream file(arguments[1], std::ios::binary);
  const Bytes samples((std::istreambuf_iterator<char>(file)), {});
  const auto reports = reports_of(samples, static_cast<std::size_t>(std::atol(arguments[2])));
  std::ofstream stream(arguments[3], std::ios::binary);
  const Behaviour behaviour = behaviour_of(count - 4, arguments + 4);

  Device device;
  bool is_started = false;
  bool is_stopped = false;
  const auto receive_report = [&](const Report& report) {
    if (report.kind == Kind::start) is_started = true;
    if (report.kind == Kind::stop) is_stopped = true;
    if (report.kind == Kind::stream)
      stream.write(reinterpret_cast<const char*>(report.payload), report.length);
  };
  while (!is_started) device.receive(-1, receive_report);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (behaviour.unplugged.count(i) > 0) return 0;
    if (behaviour.lost.count(i) == 0) device.send_report(reports[i]);
    if (behaviour.repeated.count(i) > 0) device.send_report(reports[i]);
    usleep(1000);
    device.receive(0, receive_report);
  }
  while (!is_stopped) device.receive(-1, receive_report);
}
