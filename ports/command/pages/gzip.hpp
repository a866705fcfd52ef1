// Bytes compressed as gzip (RFC 1952).
#pragma once

#include <memory>
#include <streambuf>

struct z_stream_s;

namespace discmc::command {

/// Takes bytes as the buffer of a stream, and writes them compressed to another one.
class Gzip : public std::streambuf {
 public:
  /// out: outlives this.
  explicit Gzip(std::streambuf& out);
  ~Gzip() override;

  /// Call last: writes what is left. Throws std::runtime_error when out did not take everything.
  void finish();

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;

 private:
  bool deflate(int flush);

  std::streambuf& out_;
  std::unique_ptr<z_stream_s> stream_;
  bool has_failed_ = false;
};

}  // namespace discmc::command
