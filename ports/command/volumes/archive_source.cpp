#include "archive_source.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <new>
#include <utility>

namespace discmc::command {
namespace {

// libarchive decodes names of all languages only in such a locale.
class Utf8Locale {
 public:
  Utf8Locale() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_ != nullptr) before_ = uselocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;
  ~Utf8Locale() {
    if (locale_ == nullptr) return;
    uselocale(before_);
    freelocale(locale_);
  }

 private:
  locale_t locale_;
  locale_t before_{};
};

// Returns the name of a member, or its number if the name cannot be decoded.
std::string name_of(archive_entry* entry, std::size_t number) {
  const char* name = archive_entry_pathname_utf8(entry);
  if (name == nullptr) name = archive_entry_pathname(entry);
  return name == nullptr ? std::to_string(number) : name;
}

}  // namespace

ArchiveSource::ArchiveSource(Support support) : archive_(archive_read_new(), archive_read_free) {
  if (!archive_) throw std::bad_alloc();
  support(archive_.get());
}

ArchiveSource::ArchiveSource(std::unique_ptr<ByteSource> in, Support support)
    : ArchiveSource(support) {
  in_ = std::move(in);
  const auto give = [](archive*, void* self, const void** bytes) {
    auto& source = *static_cast<ArchiveSource*>(self);
    *bytes = source.packed_.data();
    return static_cast<la_ssize_t>(source.in_->read(source.packed_.data(), source.packed_.size()));
  };
  if (archive_read_open(archive_.get(), this, nullptr, give, nullptr) < ARCHIVE_WARN) note_damage();
}

ArchiveSource::ArchiveSource(const std::filesystem::path& file, Support support)
    : ArchiveSource(support) {
  if (archive_read_open_filename(archive_.get(), file.c_str(), packed_.size()) < ARCHIVE_WARN)
    note_damage();
}

std::optional<std::string> ArchiveSource::next_member() {
  const Utf8Locale any_language;
  archive_entry* entry = nullptr;
  while (damage_.empty()) {
    const int result = archive_read_next_header(archive_.get(), &entry);
    if (result == ARCHIVE_EOF) break;
    if (result < ARCHIVE_WARN) {
      note_damage();
      break;
    }
    ++members_;
    set_part(nullptr, 0);
    is_at_end_ = false;
    if (archive_entry_filetype(entry) == AE_IFREG) return name_of(entry, members_);
  }
  is_at_end_ = true;
  return std::nullopt;
}

bool ArchiveSource::next_part() {
  if (is_at_end_ || !damage_.empty()) return false;
  const void* block = nullptr;
  std::size_t bytes = 0;
  la_int64_t offset = 0;
  int result = ARCHIVE_OK;
  do {  // empty blocks do not end the member
    result = archive_read_data_block(archive_.get(), &block, &bytes, &offset);
  } while (result == ARCHIVE_OK && bytes == 0);
  is_at_end_ = result == ARCHIVE_EOF;
  set_part(block, result == ARCHIVE_OK ? bytes : 0);
  if (result < ARCHIVE_OK) note_damage();
  return result == ARCHIVE_OK;
}

void ArchiveSource::check_end() {
  if (left_in_part() == 0) next_part();
}

void ArchiveSource::note_damage() {
  const std::string before = in_ ? in_->damage() : std::string();
  const char* text = archive_error_string(archive_.get());
  damage_ = "the compressed data is damaged";
  if (!before.empty())
    damage_ = before;
  else if (text != nullptr)
    damage_ += std::string(" (") + text + ")";
}

}  // namespace discmc::command
