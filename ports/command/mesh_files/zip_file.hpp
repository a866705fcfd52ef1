// A ZIP archive, written from its first byte to its last.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <string>

struct archive;

namespace discmc::command {

/// All that can fail throws std::runtime_error.
class ZipFile {
 public:
  /// out: outlives this. largest: no file in the archive has more bytes. Beyond 4 GiB it is of the
  /// extended kind (Zip64), which some readers do not support.
  ZipFile(std::ostream& out, std::uint64_t largest);

  /// Adds a file of what write gives to the stream, compressed.
  void add(const std::string& name, const std::function<void(std::ostream&)>& write);

  /// Call last: writes the directory.
  void finish();

 private:
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

}  // namespace discmc::command
