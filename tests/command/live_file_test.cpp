// Pipes with several readers, each from the beginning.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>
#include <streambuf>
#include <thread>

#include "command/volume_files.hpp"
#include "pages/live_file.hpp"
#include "test.hpp"

namespace {

using discmc::command::LiveFile;

// A named pipe, and a thread that writes to it.
class Pipe {
 public:
  Pipe() { REQUIRE(mkfifo(path().c_str(), 0600) == 0); }
  std::string path() const { return (folder_.path() / "pipe").string(); }
  void open() { descriptor_ = ::open(path().c_str(), O_WRONLY); }
  void write(const std::string& text) const {
    REQUIRE(::write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }
  void close() const { ::close(descriptor_); }

 private:
  volume_files::Folder folder_;
  int descriptor_ = -1;
};

class Gone : public std::streambuf {
 protected:
  int sync() override { return -1; }
};

TEST_CASE("every reader of a live file receives all bytes of the pipe, however late") {
  Pipe pipe;
  LiveFile live(pipe.path());  // there is no writer yet
  std::ostringstream early, late;
  std::thread reader([&] { live.copy_to(early); });
  pipe.open();
  pipe.write("from the ");
  pipe.write("beginning");
  const std::string much(100000, '.');
  std::thread writer([&] { pipe.write(much); });
  writer.join();
  pipe.close();
  reader.join();
  live.copy_to(late);
  CHECK(early.str() == "from the beginning" + much);
  CHECK(late.str() == early.str());
}

TEST_CASE("serving a live file stops when the reader closes, before the pipe ends") {
  Pipe pipe;
  LiveFile live(pipe.path());
  pipe.open();
  pipe.write("some");
  Gone gone;
  std::ostream out(&gone);
  out.exceptions(std::ios::badbit);
  CHECK_THROWS_AS(live.copy_to(out), std::ios_base::failure);
}

TEST_CASE("a live file that cannot be opened is refused by name") {
  CHECK_THROWS_WITH(LiveFile("missing/pipe"),
                    doctest::Contains("missing/pipe: there is no such file; check the name"));
}

}  // namespace
