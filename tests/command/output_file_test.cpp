// Output files: nothing half-written appears under their name.
#include "files/output_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"

namespace {

using command_tests::contains;
using command_tests::contents;
using discmc::command::OutputFile;
using volume_files::Folder;

// What was synced: whether it was a folder, and whether the target had its name by then.
struct Syncs {
  std::filesystem::path target;
  int error_of_files = 0;
  int error_of_folders = 0;
  std::vector<std::pair<bool, bool>> done;
};

Syncs* syncs = nullptr;

class SyncsWatched : public Syncs {
 public:
  explicit SyncsWatched(const std::filesystem::path& path) {
    target = path;
    syncs = this;
  }
  SyncsWatched(const SyncsWatched&) = delete;
  SyncsWatched& operator=(const SyncsWatched&) = delete;
  ~SyncsWatched() { syncs = nullptr; }
};

// The one file that is in a folder.
std::filesystem::path only_file(const std::filesystem::path& folder) {
  REQUIRE(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  return std::filesystem::directory_iterator(folder)->path();
}

// The error for a file that cannot be written.
template <class Write>
std::string complaint(Write write) {
  try {
    write();
  } catch (const std::exception& error) {
    return error.what();
  }
  FAIL("no error");
  return {};
}

}  // namespace

// Takes the place of the system's in this program.
extern "C" int fsync(int descriptor) {
  if (syncs == nullptr) return static_cast<int>(syscall(SYS_fsync, descriptor));
  struct stat status {};
  REQUIRE(fstat(descriptor, &status) == 0);
  const bool is_folder = S_ISDIR(status.st_mode);
  syncs->done.emplace_back(is_folder, std::filesystem::exists(syncs->target));
  errno = is_folder ? syncs->error_of_folders : syncs->error_of_files;
  return errno == 0 ? 0 : -1;
}

TEST_CASE("a file appears only once it is complete") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  {
    OutputFile file(path);
    file.stream() << "text";
    file.stream().flush();
    CHECK(!std::filesystem::exists(path));
    file.commit();
    CHECK(contents(path) == "text");
  }
  CHECK(contents(path) == "text");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("the start of a file can be written last") {
  const Folder folder;
  const auto path = folder.path() / "v.stl";
  OutputFile file(path);
  REQUIRE(file.can_seek());
  file.stream() << std::string(10000, 'x');
  file.stream().seekp(0);
  file.stream() << "start";
  file.commit();
  CHECK(contents(path) == "start" + std::string(9995, 'x'));
  CHECK(!OutputFile("/dev/null").can_seek());
  CHECK(!OutputFile("-.stl").can_seek());
}

TEST_CASE("an uncommitted file leaves no trace and keeps the previous file") {
  const Folder folder;
  const auto path = folder.write("a.obj", "before");
  {
    OutputFile file(path);
    file.stream() << std::string(100000, 'x');
  }
  CHECK(contents(path) == "before");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  OutputFile file(path);
  file.stream() << "after";
  file.commit();
  CHECK(contents(path) == "after");
}

TEST_CASE("two outputs of the same name write separate files with unpredictable names") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  OutputFile first(path);
  const auto temporary = only_file(folder.path());
  OutputFile second(path);
  first.stream() << "first";
  second.stream() << "second";
  first.commit();
  CHECK(contents(path) == "first");
  second.commit();
  CHECK(contents(path) == "second");
  const OutputFile third(path);
  CHECK(!std::filesystem::exists(temporary));
}

TEST_CASE("a link that waits under the name of a process is not followed") {
  const Folder folder;
  const auto victim = folder.write("victim", "before");
  const auto link = folder.path() / ("a.obj.part" + std::to_string(getpid()));
  std::filesystem::create_symlink("victim", link);
  {
    OutputFile file(folder.path() / "a.obj");
    file.stream() << "text";
    file.commit();
  }
  CHECK(contents(victim) == "before");
  CHECK(std::filesystem::is_symlink(link));
}

TEST_CASE("the file is synced before its renaming, and the folder after it") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  const SyncsWatched watched(path);
  OutputFile file(path);
  file.commit();
  CHECK(watched.done == std::vector<std::pair<bool, bool>>{{false, false}, {true, true}});
}

TEST_CASE("a failing disk is reported, and a file system without sync is accepted") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  SyncsWatched watched(path);
  const auto write = [&path] {
    OutputFile file(path);
    file.stream() << "text";
    file.commit();
  };
  const std::string failure =
      path.string() + ": writing failed (Input/output error); free space, or write to another disk";
  watched.error_of_files = EIO;
  CHECK(complaint(write) == failure);
  CHECK(std::filesystem::is_empty(folder.path()));
  watched.error_of_files = EINVAL;
  watched.error_of_folders = EIO;
  CHECK(complaint(write) == failure);
  watched.error_of_folders = EINVAL;
  write();
  CHECK(only_file(folder.path()) == path);
}

TEST_CASE("a link stays a link, and its target is written") {
  const Folder folder;
  const auto file = folder.write("a.obj", "before");
  std::filesystem::create_directory(folder.path() / "links");
  const auto link = folder.path() / "links" / "b.obj", to_nothing = folder.path() / "c.obj";
  std::filesystem::create_symlink("../a.obj", link);
  std::filesystem::create_symlink(link, folder.path() / "to_link.obj");
  std::filesystem::create_symlink("d.obj", to_nothing);
  for (const auto& path : {link, folder.path() / "to_link.obj", to_nothing}) {
    OutputFile output(path);
    output.stream() << path;
    output.commit();
    CHECK(std::filesystem::is_symlink(path));
    std::ostringstream expected;
    expected << path;
    CHECK(contents(path == to_nothing ? folder.path() / "d.obj" : file) == expected.str());
  }
  CHECK(std::distance(std::filesystem::directory_iterator(link.parent_path()), {}) == 1);
}

TEST_CASE("links that lead in a circle are refused") {
  const Folder folder;
  std::filesystem::create_symlink("b.obj", folder.path() / "a.obj");
  std::filesystem::create_symlink("a.obj", folder.path() / "b.obj");
  const std::string text = complaint([&] { OutputFile file(folder.path() / "a.obj"); });
  CHECK(contains(text, "a.obj: the file cannot be written"));
}

TEST_CASE("a file that is replaced keeps its permissions") {
  using std::filesystem::perms;
  const Folder folder;
  const auto path = folder.write("a.obj", "before");
  for (const perms mode : {perms::owner_read | perms::owner_write,
                           perms::owner_read | perms::owner_write | perms::group_read}) {
    std::filesystem::permissions(path, mode);
    OutputFile file(path);
    file.stream() << "after";
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      CHECK(entry.status().permissions() == mode);  // never more, while it is written
    file.commit();
    CHECK(std::filesystem::status(path).permissions() == mode);
  }
}

TEST_CASE("a new file has the permissions that the user gives new files") {
  const Folder folder;
  for (const auto& [mask, mode] : {std::pair<mode_t, int>{0027, 0640}, {0, 0666}}) {
    const mode_t before = umask(mask);
    const auto path = folder.path() / std::to_string(mask);
    OutputFile file(path);
    file.commit();
    umask(before);
    CHECK(static_cast<int>(std::filesystem::status(path).permissions()) == mode);
  }
}

TEST_CASE("a stream that failed is not committed") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  {
    OutputFile file(path);
    file.stream() << "text";
    file.stream().setstate(std::ios::badbit);
    const std::string text = complaint([&file] { file.commit(); });
    CHECK(contains(text, path.string()));
    CHECK(contains(text, "free space, or write to another disk"));
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a missing folder, or a file in its place, is refused by name") {
  const Folder folder;
  const auto missing = folder.path() / "none", file = folder.write("a.obj", "");
  CHECK(complaint([&] { OutputFile output(missing / "b.obj"); }) ==
        missing.string() + ": the folder does not exist; create it");
  CHECK(complaint([&] { OutputFile output(file / "b.obj"); }) ==
        file.string() + ": this is not a folder; give another name");
}

TEST_CASE("a folder is not replaced by a file") {
  const Folder folder;
  const auto path = folder.path() / "a.obj";
  std::filesystem::create_directory(path);
  const std::string text = complaint([&path] {
    OutputFile file(path);
    file.stream() << "text";
    file.commit();
  });
  CHECK(contains(text, path.string()));
  CHECK(std::filesystem::is_directory(path));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
