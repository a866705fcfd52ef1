#include "output_file.hpp"

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string>

#include "write_failure.hpp"

namespace discmc::command {
namespace {

// What a signal that ends the program removes first; nothing when empty.
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

// What a link leads to, whether it is there or not. Limit: links end somewhere.
std::filesystem::path target_of(std::filesystem::path path) {
  while (std::filesystem::is_symlink(path))
    path = path.parent_path() / std::filesystem::read_symlink(path);
  return path;
}

}  // namespace

bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || (!path.has_parent_path() && path.stem() == "-" && path.has_extension());
}

std::string output_for_people(const std::filesystem::path& path) {
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
    temporary_ = target_;
    temporary_ += ".part" + std::to_string(getpid());
    set_unfinished(temporary_.string());
  }
  file_.open(is_in_place() ? path_ : temporary_, std::ios::binary);
  if (!file_)
    throw std::runtime_error(path.string() +
                             ": the file cannot be written; check the folder and its permissions");
  if (!is_in_place() && std::filesystem::exists(status))
    std::filesystem::permissions(temporary_, status.permissions());
}

OutputFile::~OutputFile() {
  if (is_standard_output() || is_committed_ || is_in_place()) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
  set_unfinished({});
}

std::ostream& OutputFile::stream() {
  return is_standard_output() ? std::cout : static_cast<std::ostream&>(file_);
}

void OutputFile::commit() {
  stream().flush();
  if (!stream()) throw std::runtime_error(output_for_people(path_) + ": " + write_failure());
  if (is_standard_output()) return;
  file_.close();
  if (!file_) throw std::runtime_error(path_.string() + ": " + write_failure());
  std::error_code error;
  if (!is_in_place()) std::filesystem::rename(temporary_, target_, error);
  if (error)
    throw std::runtime_error(path_.string() + ": the file cannot be replaced (" + error.message() +
                             "); give another name");
  is_committed_ = true;
  set_unfinished({});
}

}  // namespace discmc::command
