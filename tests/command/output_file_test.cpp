// Output files: no incomplete file has the name of the output.
#include "files/output_file.hpp"

#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "command.hpp"

namespace {

using command_tests::contains;
using command_tests::contents;
using discmc::command::OutputFile;
using volume_files::Folder;

// Synced descriptors: whether each was a folder, and whether the target had its name then.
struct Syncs {
  std::filesystem::path target;
  int error_of_files = 0;
  int error_of_folders = 0;
  std::vector<std::pair<bool, bool>> done;
};

Syncs* syncs = nullptr;

class SyncsWatched : public Syncs {
 public:
  explicit SyncsWatched(const std::filesystem::path& file) {
    target = file;
    syncs = this;
  }
  SyncsWatched(const SyncsWatched&) = delete;
  SyncsWatched& operator=(const SyncsWatched&) = delete;
  ~SyncsWatched() { syncs = nullptr; }
};

std::filesystem::path only_file(const std::filesystem::path& folder) {
  REQUIRE(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  return std::filesystem::directory_iterator(folder)->path();
}

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

struct Target : Folder {
  const std::filesystem::path target = path() / "a.obj";
};

}  // namespace

// Replaces the system's function in this program.
extern "C" int fsync(int descriptor) {
  if (syncs == nullptr) return static_cast<int>(syscall(SYS_fsync, descriptor));
  struct stat status {};
  REQUIRE(fstat(descriptor, &status) == 0);
  const bool is_folder = S_ISDIR(status.st_mode);
  syncs->done.emplace_back(is_folder, std::filesystem::exists(syncs->target));
  errno = is_folder ? syncs->error_of_folders : syncs->error_of_files;
  return errno == 0 ? 0 : -1;
}

TEST_CASE_FIXTURE(Target, "an output file appears only when committed") {
  {
    OutputFile file(target);
    file.stream() << "text";
    file.stream().flush();
    CHECK(!std::filesystem::exists(target));
    file.commit();
    CHECK(contents(target) == "text");
  }
  CHECK(contents(target) == "text");
  CHECK(std::distance(std::filesystem::directory_iterator(path()), {}) == 1);
}

TEST_CASE_FIXTURE(Folder, "the start of an output file can be written last") {
  const auto target = path() / "v.stl";
  OutputFile file(target);
  REQUIRE(file.can_seek());
  file.stream() << std::string(10000, 'x');
  file.stream().seekp(0);
  file.stream() << "start";
  file.commit();
  CHECK(contents(target) == "start" + std::string(9995, 'x'));
  CHECK(!OutputFile("/dev/null").can_seek());
  CHECK(!OutputFile("-.stl").can_seek());
}

TEST_CASE_FIXTURE(
    Folder, "an uncommitted output file leaves no temporary file and keeps the previous file") {
  const auto target = write("a.obj", "before");
  {
    OutputFile file(target);
    file.stream() << std::string(100000, 'x');
  }
  CHECK(contents(target) == "before");
  CHECK(std::distance(std::filesystem::directory_iterator(path()), {}) == 1);
  OutputFile file(target);
  file.stream() << "after";
  file.commit();
  CHECK(contents(target) == "after");
}

TEST_CASE_FIXTURE(
    Target,
    "two outputs with one name write to separate temporary files with unpredictable names") {
  OutputFile first(target);
  const auto temporary = only_file(path());
  OutputFile second(target);
  first.stream() << "first";
  second.stream() << "second";
  first.commit();
  CHECK(contents(target) == "first");
  second.commit();
  CHECK(contents(target) == "second");
  const OutputFile third(target);
  CHECK(!std::filesystem::exists(temporary));
}

TEST_CASE_FIXTURE(Folder, "a symbolic link with a guessed temporary name is not followed") {
  const auto victim = write("victim", "before");
  const auto link = path() / ("a.obj.part" + std::to_string(getpid()));
  std::filesystem::create_symlink("victim", link);
  {
    OutputFile file(path() / "a.obj");
    file.stream() << "text";
    file.commit();
  }
  CHECK(contents(victim) == "before");
  CHECK(std::filesystem::is_symlink(link));
}

TEST_CASE_FIXTURE(Target, "committing syncs the file before renaming it, and then the folder") {
  const SyncsWatched watched(target);
  OutputFile file(target);
  file.commit();
  CHECK(watched.done == std::vector<std::pair<bool, bool>>{{false, false}, {true, true}});
}

TEST_CASE_FIXTURE(
    Target, "a failing sync of an output is reported; a file system without sync is accepted") {
  SyncsWatched watched(target);
  const auto save = [&] {
    OutputFile file(target);
    file.stream() << "text";
    file.commit();
  };
  const std::string failure =
      target.string() +
      ": writing failed (Input/output error); free space, or write to another disk";
  watched.error_of_files = EIO;
  CHECK(complaint(save) == failure);
  CHECK(std::filesystem::is_empty(path()));
  watched.error_of_files = EINVAL;
  watched.error_of_folders = EIO;
  CHECK(complaint(save) == failure);
  watched.error_of_folders = EINVAL;
  save();
  CHECK(only_file(path()) == target);
}

TEST_CASE_FIXTURE(Folder,
                  "an output that is a symbolic link stays a link, and its target is written") {
  const auto file = write("a.obj", "before");
  std::filesystem::create_directory(path() / "links");
  const auto link = path() / "links" / "b.obj", to_nothing = path() / "c.obj";
  std::filesystem::create_symlink("../a.obj", link);
  std::filesystem::create_symlink(link, path() / "to_link.obj");
  std::filesystem::create_symlink("d.obj", to_nothing);
  for (const auto& target : {link, path() / "to_link.obj", to_nothing}) {
    OutputFile output(target);
    output.stream() << target;
    output.commit();
    CHECK(std::filesystem::is_symlink(target));
    std::ostringstream expected;
    expected << target;
    CHECK(contents(target == to_nothing ? path() / "d.obj" : file) == expected.str());
  }
  CHECK(std::distance(std::filesystem::directory_iterator(link.parent_path()), {}) == 1);
}

TEST_CASE_FIXTURE(Folder, "an output that is a cycle of symbolic links is refused") {
  std::filesystem::create_symlink("b.obj", path() / "a.obj");
  std::filesystem::create_symlink("a.obj", path() / "b.obj");
  const std::string text = complaint([&] { OutputFile file(path() / "a.obj"); });
  CHECK(contains(text, "a.obj: the file cannot be written"));
}

TEST_CASE_FIXTURE(Folder, "a replaced output file keeps its permissions") {
  using std::filesystem::perms;
  const auto target = write("a.obj", "before");
  for (const perms mode : {perms::owner_read | perms::owner_write,
                           perms::owner_read | perms::owner_write | perms::group_read}) {
    std::filesystem::permissions(target, mode);
    OutputFile file(target);
    file.stream() << "after";
    for (const auto& entry : std::filesystem::directory_iterator(path()))
      CHECK(entry.status().permissions() == mode);  // the permissions while the file is written
    file.commit();
    CHECK(std::filesystem::status(target).permissions() == mode);
  }
}

TEST_CASE_FIXTURE(Folder, "a new output file has the permissions that the umask allows") {
  for (const auto& [mask, mode] : {std::pair<mode_t, int>{0027, 0640}, {0, 0666}}) {
    const mode_t before = umask(mask);
    const auto target = path() / std::to_string(mask);
    OutputFile file(target);
    file.commit();
    umask(before);
    CHECK(static_cast<int>(std::filesystem::status(target).permissions()) == mode);
  }
}

TEST_CASE_FIXTURE(Target, "an output whose stream failed is not committed") {
  {
    OutputFile file(target);
    file.stream() << "text";
    file.stream().setstate(std::ios::badbit);
    const std::string text = complaint([&file] { file.commit(); });
    CHECK(contains(text, target.string()));
    CHECK(contains(text, "free space, or write to another disk"));
  }
  CHECK(std::filesystem::is_empty(path()));
}

TEST_CASE_FIXTURE(Folder, "an output folder that is missing or is a file is refused by name") {
  const auto missing = path() / "none", file = write("a.obj", "");
  CHECK(complaint([&] { OutputFile output(missing / "b.obj"); }) ==
        missing.string() + ": the folder does not exist; create it");
  CHECK(complaint([&] { OutputFile output(file / "b.obj"); }) ==
        file.string() + ": this is not a folder; give another name");
}

TEST_CASE_FIXTURE(Target, "an output that is an existing folder is refused") {
  std::filesystem::create_directory(target);
  const std::string text = complaint([&] {
    OutputFile file(target);
    file.stream() << "text";
    file.commit();
  });
  CHECK(contains(text, target.string()));
  CHECK(std::filesystem::is_directory(target));
  CHECK(std::distance(std::filesystem::directory_iterator(path()), {}) == 1);
}
