// The device and the lines to it: QEMU, started here, or a device at the given paths.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "qemu.hpp"
#include "simulation.hpp"

namespace discmc::simulator {

/// A folder for sockets, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

class Device {
 public:
  /// Opens the named lines, or starts QEMU with lines of its own, and waits until all are
  /// connected. Throws std::runtime_error.
  explicit Device(const Options& options);

  Simulation::Lines lines() const { return {*rows_, *stream_, monitor_.get()}; }

  /// Returns the fault at the end of the firmware; empty if it ended with this code, or if its end
  /// is unknown.
  std::string mistake(int expected_code) const;

  /// Returns the output of the firmware, if QEMU is started here.
  std::string console() const;

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Line> rows_, stream_, monitor_;
  std::unique_ptr<Qemu> qemu_;
};

}  // namespace discmc::simulator
