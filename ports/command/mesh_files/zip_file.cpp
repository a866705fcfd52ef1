#include "zip_file.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <stdexcept>
#include <streambuf>

namespace discmc::command {
namespace {

la_ssize_t write_to_stream(archive*, void* out, const void* bytes, std::size_t count) {
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  return stream ? static_cast<la_ssize_t>(count) : -1;
}

void require_ok(int result) {
  if (result != ARCHIVE_OK) throw std::runtime_error("writing failed");
}

// What is put into it goes to the entry that was begun last.
class EntryBuffer : public std::streambuf {
 public:
  explicit EntryBuffer(archive* to) : archive_(to) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    return archive_write_data(archive_, bytes, static_cast<std::size_t>(count));
  }

 private:
  archive* archive_;
};

}  // namespace

ZipFile::ZipFile(std::ostream& out, std::uint64_t largest)
    : archive_(archive_write_new(), archive_write_free) {
  if (!archive_) throw std::bad_alloc();
  require_ok(archive_write_set_format_zip(archive_.get()));
  if (largest <= 0xFFFFFFFFu)
    require_ok(archive_write_set_format_option(archive_.get(), "zip", "zip64", nullptr));
  require_ok(archive_write_set_bytes_in_last_block(archive_.get(), 1));
  require_ok(archive_write_open(archive_.get(), &out, nullptr, write_to_stream, nullptr));
}

void ZipFile::add(const std::string& name, const std::function<void(std::ostream&)>& write) {
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                       archive_entry_free);
  if (!entry) throw std::bad_alloc();
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  require_ok(archive_write_header(archive_.get(), entry.get()));
  EntryBuffer buffer(archive_.get());
  std::ostream stream(&buffer);
  write(stream);
  if (!stream) throw std::runtime_error("writing failed");
  require_ok(archive_write_finish_entry(archive_.get()));
}

void ZipFile::finish() {
  require_ok(archive_write_close(archive_.get()));
}

}  // namespace discmc::command
