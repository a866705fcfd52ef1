// A growing file: the content of a pipe, for all readers from its beginning.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

namespace discmc::command {

/// Reads a pipe in a thread of its own, and keeps all bytes. The thread starts in the constructor.
class LiveFile {
 public:
  /// The thread reads no further bytes. Units: bytes.
  static constexpr std::size_t max_bytes = std::size_t{1} << 30;

  /// path: a pipe, any readable file, or standard input ("-"). A named pipe needs no writer yet.
  /// Throws std::runtime_error if the path cannot be opened.
  explicit LiveFile(const std::string& path);
  LiveFile(const LiveFile&) = delete;
  LiveFile& operator=(const LiveFile&) = delete;
  /// Does not wait for the end of the pipe. Limit: no copy_to() is running.
  ~LiveFile();

  /// Writes all bytes from the first on, as they arrive, and returns at the end of the pipe. While
  /// none arrive, flushes `out` regularly, so that it can throw if its reader is gone. Several
  /// threads may call it.
  void copy_to(std::ostream& out);

 private:
  void read();
  void append(const char* bytes, std::size_t count);
  void end();

  std::string path_;
  int descriptor_;
  std::atomic<bool> is_stopping_{false};
  std::mutex mutex_;  // protects the members below
  std::condition_variable has_more_;
  std::string bytes_;
  bool is_at_end_ = false;
  std::thread reader_;
};

}  // namespace discmc::command
