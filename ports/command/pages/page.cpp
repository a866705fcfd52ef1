#include "page.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <streambuf>

#include "files/write_failure.hpp"
#include "text/base64.hpp"
#include "text/name_text.hpp"

namespace discmc::command {
namespace {

// A stream buffer that compresses its bytes as gzip (RFC 1952) and writes them to another buffer.
class Gzip : public std::streambuf {
 public:
  // out: outlives this.
  explicit Gzip(std::streambuf& out) : out_(out) {
    constexpr int window_bits = 15, with_gzip_header = 16, memory_level = 9;
    if (deflateInit2(&stream_, Z_BEST_COMPRESSION, Z_DEFLATED, window_bits + with_gzip_header,
                     memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;
  ~Gzip() override { deflateEnd(&stream_); }

  // Writes the rest. Call it last. Throws std::runtime_error if `out` did not accept everything.
  void finish() {
    if (!deflate(Z_FINISH)) throw std::runtime_error(write_failure());
  }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    std::streamsize written = 0;
    while (written < count) {
      const std::streamsize part =
          std::min<std::streamsize>(count - written, std::numeric_limits<int>::max());
      stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes + written));
      stream_.avail_in = static_cast<uInt>(part);
      if (!deflate(Z_NO_FLUSH)) return written;
      written += part;
    }
    return written;
  }

 private:
  bool deflate(int flush) {
    std::array<char, 1 << 16> buffer;
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream_.avail_out = static_cast<uInt>(buffer.size());
      ::deflate(&stream_, flush);
      const auto count = static_cast<std::streamsize>(buffer.size() - stream_.avail_out);
      has_failed_ = has_failed_ || out_.sputn(buffer.data(), count) != count;
    } while (stream_.avail_out == 0);
    return !has_failed_;
  }

  std::streambuf& out_;
  z_stream stream_{};
  bool has_failed_ = false;
};

// The data is placed before this script, which reads it.
constexpr std::string_view scripts = "<script type=\"application/base64\" id=\"module\">";

// The parts of the page before and after the found text.
struct PageParts {
  std::string_view head, scripts;
};

PageParts parts_of_page() {
  const std::string_view page = page_template();
  const std::size_t begin = page.find(scripts);
  if (begin == std::string_view::npos)
    throw std::runtime_error(
        "this discmc was built without the page; run scripts/setup page and build again");
  return {page.substr(0, begin), page.substr(begin)};
}

std::string begin_data(const std::string& name) {
  return "<script type=\"application/base64\" id=\"data\" data-name=\"" + xml_attribute(name) + '"';
}

constexpr std::string_view end_data = "</script>\n";

// The policy of a page that needs no network.
constexpr std::string_view no_source = "default-src 'none';";

}  // namespace

void write_page(const std::string& name, const std::function<void(std::ostream&)>& write,
                std::ostream& out) {
  const PageParts page = parts_of_page();
  out << page.head << begin_data(name) << " data-encoding=\"gzip\">";
  Base64 base64(out);
  Gzip gzip(base64);
  std::ostream data(&gzip);
  write(data);
  gzip.finish();
  base64.finish();
  out << end_data << page.scripts;
}

bool is_page(const std::filesystem::path& file) {
  const std::string_view head = page_template().substr(0, 4096);
  std::ifstream in(file, std::ios::binary);
  std::string begin(head.size(), '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return !head.empty() && begin == head;
}

std::string served_page(const std::string& name, const std::string& source, bool is_live) {
  const PageParts page = parts_of_page();
  std::string text(page.head);
  const std::size_t policy = text.find(no_source);
  if (policy == std::string::npos)
    throw std::logic_error("the page has no policy for its connections");
  text.insert(policy + no_source.size(), " connect-src 'self';");
  text += begin_data(name) + " data-source=\"" + source + '"' + (is_live ? " data-live" : "") + '>';
  return text.append(end_data).append(page.scripts);
}

}  // namespace discmc::command
