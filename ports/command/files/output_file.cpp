#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <random>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "write_failure.hpp"

namespace discmc::command {
namespace {

// Writes to a file descriptor, which std::ofstream cannot do. Only a flush of the stream writes the
// rest of the buffer. Seeks if the file can. Errors: the stream turns bad, and errno has the cause.
class DescriptorBuffer final : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor) { empty(); }

 protected:
  int_type overflow(int_type byte) override {
    if (sync() != 0) return traits_type::eof();
    if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
    return sputc(traits_type::to_char_type(byte));
  }
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    if (count <= epptr() - pptr()) return std::streambuf::xsputn(bytes, count);
    return sync() == 0 && write_all(bytes, static_cast<std::size_t>(count)) ? count : 0;
  }
  int sync() override {
    const bool is_written = write_all(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    empty();
    return is_written ? 0 : -1;
  }
  pos_type seekpos(pos_type place, std::ios_base::openmode) override {
    if (sync() != 0) return pos_type(off_type(-1));
    return pos_type(lseek(descriptor_, static_cast<off_t>(place), SEEK_SET));
  }

 private:
  void empty() { setp(waiting_.data(), waiting_.data() + waiting_.size()); }
  bool write_all(const char* bytes, std::size_t count) const {
    while (count > 0) {
      const ssize_t written = write(descriptor_, bytes, count);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes += written;
      count -= static_cast<std::size_t>(written);
    }
    return true;
  }

  int descriptor_;
  std::array<char, 8192> waiting_;
};

// The file that a terminating signal removes first; empty: none.
char unfinished[4096] = "";

void remove_unfinished(int signal) {
  if (unfinished[0] != '\0') unlink(unfinished);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void set_unfinished(const std::string& file) {
  unfinished[0] = '\0';
  if (file.empty() || file.size() >= sizeof unfinished) return;
  file.copy(unfinished + 1, file.size() - 1, 1);
  unfinished[file.size()] = '\0';
  unfinished[0] = file[0];
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_unfinished) == SIG_IGN) std::signal(signal, SIG_IGN);
}

// Returns the target of a chain of links, even if it does not exist. Limit: the chain ends.
std::filesystem::path target_of(std::filesystem::path path) {
  while (std::filesystem::is_symlink(path))
    path = path.parent_path() / std::filesystem::read_symlink(path);
  return path;
}

std::string random_letters() {
  constexpr int count = 12;
  std::random_device source;
  std::uniform_int_distribution<int> letter('a', 'z');
  std::string letters;
  while (letters.size() < count) letters += static_cast<char>(letter(source));
  return letters;
}

// Creates a file beside the target under an unpredictable, unused name. Another process may write
// to the same target, and others may write into the folder.
int create_beside(const std::filesystem::path& target, mode_t mode,
                  std::filesystem::path& temporary) {
  constexpr int max_tries = 100;
  int descriptor = -1;
  for (int i = 0; i < max_tries && descriptor < 0 && (i == 0 || errno == EEXIST); ++i) {
    temporary = target;
    temporary += ".part" + random_letters();
    descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  }
  return descriptor;
}

// Writes the file to the disk, if the file system can, so that it survives a power failure.
bool is_synced(int descriptor) {
  return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

// Writes the names in a folder to the disk. A folder without read permission cannot be synced.
bool is_folder_synced(const std::filesystem::path& folder) {
  const int descriptor =
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;
  const bool is_done = is_synced(descriptor);
  const int reason = errno;
  close(descriptor);
  errno = reason;
  return is_done;
}

}  // namespace

bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || (!path.has_parent_path() && path.stem() == "-" && path.has_extension());
}

std::string output_display_name(const std::filesystem::path& path) {
  return is_standard_output(path) ? "standard output" : path.string();
}

void require_folder(const std::filesystem::path& folder) {
  const std::filesystem::path named = folder.empty() ? "." : folder;
  std::error_code ignored;
  const auto status = std::filesystem::status(named, ignored);
  if (!std::filesystem::exists(status))
    throw std::runtime_error(named.string() + ": the folder does not exist; create it");
  if (!std::filesystem::is_directory(status))
    throw std::runtime_error(named.string() + ": this is not a folder; give another name");
  if (access(named.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error(named.string() +
                             ": no file can be created in this folder; check its permissions");
}

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path) {
  if (is_standard_output()) return;
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::none)
    throw std::runtime_error(path.string() + ": the file cannot be written (" + error.message() +
                             "); give another name");
  if (std::filesystem::is_directory(status))
    throw std::runtime_error(path.string() + ": this is a folder; give the name of a file");
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    target_ = target_of(path);
    require_folder(target_.parent_path());
    open_beside(status);
  } else {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  }
  if (descriptor_ < 0)
    throw std::runtime_error(path.string() +
                             ": the file cannot be written; check the folder and its permissions");
  buffer_ = std::make_unique<DescriptorBuffer>(descriptor_);
  stream_.rdbuf(buffer_.get());
}

void OutputFile::open_beside(const std::filesystem::file_status& replaced) {
  const bool replaces = std::filesystem::exists(replaced);
  constexpr mode_t own = S_IRUSR | S_IWUSR;
  constexpr mode_t usual = own | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;  // before umask
  descriptor_ = create_beside(target_, replaces ? own : usual, temporary_);
  if (descriptor_ < 0) return;
  set_unfinished(temporary_.string());
  if (!replaces || fchmod(descriptor_, static_cast<mode_t>(replaced.permissions())) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  discard();
  throw std::runtime_error(path_.string() + ": a new file cannot have its permissions (" + reason +
                           "); give another name");
}

OutputFile::~OutputFile() {
  discard();
}

void OutputFile::discard() {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  set_unfinished({});
}

std::ostream& OutputFile::stream() {
  return is_standard_output() ? std::cout : stream_;
}

void OutputFile::commit() {
  const auto require = [this](bool is_done) {
    if (!is_done) throw std::runtime_error(output_display_name(path_) + ": " + write_failure());
  };
  require(static_cast<bool>(stream().flush()));
  if (is_standard_output()) return;
  require(is_in_place() || is_synced(descriptor_));
  require(close(std::exchange(descriptor_, -1)) == 0);
  if (is_in_place()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error)
    throw std::runtime_error(path_.string() + ": the file cannot be replaced (" + error.message() +
                             "); give another name");
  temporary_.clear();
  set_unfinished({});
  require(is_folder_synced(target_.parent_path()));
}

}  // namespace discmc::command
