// Pages that contain a volume or a stream.
#include "command.hpp"
#include "pages/page.hpp"

namespace {

using namespace command_tests;
using discmc::reference::ball;

// Writes the file embedded in a page. Returns its name in the page.
std::string unpack(const Workshop& workshop, const std::string& page, const std::string& file) {
  const std::string text = workshop.read(page);
  const std::size_t element = text.find("id=\"data\" data-name=\"");
  REQUIRE(element != std::string::npos);
  const std::size_t name = text.find("data-name=\"", element) + 11;
  const std::size_t begin = text.find('>', element) + 1;
  workshop.write("base64", text.substr(begin, text.find('<', begin) - begin));
  const Result result = workshop.shell("base64 -d base64 | gzip -d > " + file);
  CHECK(result.code == 0);
  CHECK(result.error.empty());
  return text.substr(name, text.find('"', name) - name);
}

// Checks whether there is a page; if not, checks the error of the command.
bool has_page(const Workshop& workshop) {
  if (!discmc::command::page_template().empty()) return true;
  workshop.fails("view v.nrrd --no-open", 1, {"built without the page"});
  CHECK(workshop.file_names() == std::vector<std::string>{"v.nrrd"});
  return false;
}

// v.nrrd, with a placement in the patient.
void write_in_space(const Workshop& workshop) {
  workshop.write("v.nrrd", ball({20, 20, 20}, {19, 19, 15}, 100),
                 "space: left-posterior-superior\nspace directions: (0,0.5,0) (-1,0,0) (0,0,2)\n"
                 "space origin: (1,2,3)\n");
}

struct Ball : Workshop {
  Ball() { write("v.nrrd", ball({20, 20, 20}, {19, 19, 15}, 100)); }
};

}  // namespace

TEST_CASE_FIXTURE(Workshop,
                  "the page that view writes for a volume contains its samples and its name") {
  write_in_space(*this);
  if (!has_page(*this)) return;
  CHECK(contains(done("view v.nrrd --no-open"), "v.html: "));
  CHECK(unpack(*this, "v.html", "inside.nii") == "v.nrrd");
  done("extract v.nrrd --iso 100 -o v.stl");
  done("extract inside.nii --iso 100 -o inside.stl");
  CHECK(read("inside.stl") == read("v.stl"));
  CHECK(contains(read("v.html"), "</html>"));
  done("view v.nrrd --no-open");  // replaces the page
}

TEST_CASE_FIXTURE(Ball, "the page of a stream contains its mesh if --surface is given") {
  if (!has_page(*this)) return;
  done("extract v.nrrd --iso 100 --wire slices -q -o v.dmc");
  done("view v.dmc --surface relaxed --no-open -o page.html");
  CHECK(unpack(*this, "page.html", "inside.glb") == "v.dmc");
  CHECK(read("inside.glb").substr(0, 4) == "glTF");
}

TEST_CASE_FIXTURE(Ball,
                  "the page of a volume with --iso contains a stream of slices of that surface") {
  if (!has_page(*this)) return;
  done("view v.nrrd --iso 100 --median 3 -o page.html --no-open");
  CHECK(unpack(*this, "page.html", "inside.dmc") == "v.nrrd at 100.dmc");
  done("extract v.nrrd --iso 100 --median 3 --wire slices -o v.dmc");
  CHECK(read("inside.dmc") == read("v.dmc"));
  fails("view v.nrrd --iso 255 -o none.html --no-open", 1, {"10 to 200"});
  CHECK_FALSE(contains(shell("ls").out, "none.html"));
}

TEST_CASE_FIXTURE(Ball, "the page of a stream contains its bytes, even those of a damaged stream") {
  if (!has_page(*this)) return;
  done("extract v.nrrd --iso 100 -o 'a\"&b.dmc'");
  done("view 'a\"&b.dmc' -o page.html --no-open");
  CHECK(unpack(*this, "page.html", "inside.dmc") == "a&quot;&amp;b.dmc");
  CHECK(read("inside.dmc") == read("a\"&b.dmc"));
  CHECK(shell("\"$discmc\" view - -o - < inside.dmc > piped.html").code == 0);
  CHECK(unpack(*this, "piped.html", "piped.dmc") == "standard input");
  CHECK(read("piped.dmc") == read("inside.dmc"));
  CHECK(shell("mkfifo pipe; cat inside.dmc > pipe & \"$discmc\" view pipe -o pipe.html --no-open")
            .code == 0);
  CHECK(unpack(*this, "pipe.html", "piped.dmc") == "pipe");
  CHECK(read("piped.dmc") == read("inside.dmc"));
  shell("head -c 300 inside.dmc > cut.dmc");
  const Result cut = run("view cut.dmc --no-open");
  CHECK(cut.code == 3);
  CHECK(contains(cut.error, "the stream is incomplete"));
  unpack(*this, "cut.html", "inside.dmc");
  CHECK(read("inside.dmc") == read("cut.dmc"));
}

TEST_CASE_FIXTURE(Workshop,
                  "the page of --labels contains the labels' placed meshes, names and colours") {
  write_in_space(*this);
  if (!has_page(*this)) return;
  write("t.txt", "10 air 0 0 255\n200 \"my bone\" 255 0 0\n");
  const std::string labels = " --labels 'my bone',10 --label-table t.txt -o ";
  done("view v.nrrd --no-open" + labels + "page.html");
  CHECK(unpack(*this, "page.html", "inside.glb") == "v.nrrd");
  done("extract v.nrrd -q --normals surface" + labels + "v.glb");
  const std::string inside = read("inside.glb"), expected = read("v.glb");
  // Only the normals differ: the page has the normals that render uses.
  CHECK(inside.size() == expected.size());
  const std::size_t json = expected.find("accessors");
  CHECK(inside.substr(0, json) == expected.substr(0, json));
  CHECK(contains(inside, "\"name\":\"my bone\""));
}

TEST_CASE_FIXTURE(Ball, "the page of a mesh file contains its faces, names and colours") {
  if (!has_page(*this)) return;
  if (contains(run("compare v.nrrd none.stl --iso 1").error, "without Assimp")) return;
  write("t.txt", "10 air 0 0 255\n200 bone 255 0 0\n");
  done("extract v.nrrd --labels all --label-table t.txt -q -o v.glb");
  done("extract v.nrrd --iso 100 -q -o v.stl");
  for (const std::string name : {"v.glb", "v.stl"}) {
    INFO(name);
    done("view " + name + " --no-open -o page.html");
    CHECK(unpack(*this, "page.html", "inside.glb") == name);
    CHECK(contains(done("compare inside.glb " + name),
                   "A to B, mm                0.0000      0.0000      0.0000"));
    CHECK(contains(read("inside.glb"), "\"NORMAL\""));
    CHECK(contains(read("inside.glb"), "\"name\":\"bone\"") == (name == "v.glb"));
  }
}

TEST_CASE_FIXTURE(
    Ball, "view opens the page with $BROWSER, and prints the page's path if there is no browser") {
  if (!has_page(*this)) return;
  write("browser", "#!/bin/sh\necho \"$1\" > opened.new\nmv opened.new opened\n");
  const Result result = shell(
      "chmod +x browser; BROWSER=./browser \"$discmc\" view v.nrrd;"
      "for i in $(seq 100); do [ -e opened ] && break; sleep 0.1; done");
  CHECK(result.error.empty());
  CHECK(read("opened") == "v.html\n");
  const Result none =
      shell("unset BROWSER DISPLAY WAYLAND_DISPLAY; \"$discmc\" view v.nrrd -o other.html");
  CHECK(none.code == 0);
  CHECK(contains(none.error, "open other.html"));
}

TEST_CASE_FIXTURE(Ball, "view refuses to overwrite files or ignore options, and names the remedy") {
  write("v.html", "precious");
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    fails("view " + arguments, 2, {part});
  };
  refused("v.nrrd", "overwrite it with -o v.html");
  refused("- --no-open", "give -o PAGE.html");
  refused("'*.png'", "give -o PAGE.html");
  refused("v.nrrd -o v.png", "give a name that ends in .html");
  refused("v.nrrd -o w.html --median 3", "add --iso auto");
  refused("v.nrrd -o w.html --labels all --iso 3", "--iso");
  refused("v.nrrd -o w.html --iso 3 --label-table t.txt", "add --label N or --labels all");
  refused("v.nrrd -o w.html --labels all --mask v.nrrd --median 3", "leave out --median");
  refused("v.stl -o w.html --iso 3", "v.stl is a mesh; leave it out");
  refused("v.dmc -o w.html --labels all", "v.dmc is a stream; leave it out");
  refused("v.nrrd --serve -o w.html", "--output");
  refused("v.nrrd --serve --port 0", "--port");
  refused("v.nrrd -o w.html --port 8000", "--serve");
  CHECK(read("v.html") == "precious");
}

TEST_CASE_FIXTURE(Workshop, "a volume too large for a browser is refused with the remedy") {
  write("zeros", "");
  const Result result = shell(
      "truncate -s 268500992 zeros; \"$discmc\" view zeros --dims 4097,256,256 --type u8 "
      "-o zeros.html --no-open");
  CHECK(result.code == 1);
  CHECK(contains(result.error, "give --iso auto, --shrink 2 or a part by --crop"));
  CHECK(file_names() == std::vector<std::string>{"zeros"});
}
