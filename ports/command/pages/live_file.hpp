// A file that grows: what comes from a pipe, for all who want it from the beginning.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

namespace discmc::command {

/// Reads a pipe from its construction on, in a thread of its own, and keeps all that came.
class LiveFile {
 public:
  /// What comes beyond is not read. Units: bytes.
  static constexpr std::size_t max_bytes = std::size_t{1} << 30;

  /// path: a pipe, or any file that can be read; standard input by the name "-". A named pipe need
  /// not have a writer yet. Throws std::runtime_error when it cannot be opened.
  explicit LiveFile(const std::string& path);
  LiveFile(const LiveFile&) = delete;
  LiveFile& operator=(const LiveFile&) = delete;
  /// Does not wait for the end of the pipe. Limit: no copy_to() is under way.
  ~LiveFile();

  /// Writes all from the first byte on, as it comes, and returns at the end of the pipe. While
  /// nothing comes `out` is flushed now and then, so that it can throw if it is no longer
  /// read. For several threads at a time.
  void copy_to(std::ostream& out);

 private:
  void read();
  void append(const char* bytes, std::size_t count);
  void end();

  std::string path_;
  int descriptor_;
  std::atomic<bool> is_stopping_{false};
  std::mutex mutex_;  // of what follows
  std::condition_variable has_more_;
  std::string bytes_;
  bool is_at_end_ = false;
  std::thread reader_;
};

}  // namespace discmc::command
