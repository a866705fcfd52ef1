// Runs the commands that messages advise, and checks that they work.
#include "command.hpp"
#include "pages/page.hpp"

namespace {

using namespace command_tests;
using volume_files::Nifti;
using volume_files::npy;
using volume_files::nrrd;

struct Advice {
  std::string arguments;  // the arguments, which fail
  std::string advice;     // a part of the message
  std::string then;       // the arguments that follow the advice
};

// Six by five by four voxels as text, with on voxels in the middle.
std::string text_volume(const std::string& off, const std::string& on) {
  std::string samples;
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 6; ++x)
        samples += (x % 5 != 0 && y % 4 != 0 && z % 3 != 0 ? on : off) + ' ';
  return samples;
}

std::string volume_of(const std::string& samples, const std::string& type = "short",
                      const std::string& lines = "") {
  return nrrd("type: " + type + "\nencoding: ascii\nspacings: 1 1 1\n" + lines, "6 5 4") + "\n" +
         samples;
}

struct Inputs : Workshop {
  Inputs() {
    write("v.nrrd", volume_of(text_volume("10", "200")));
    write("mri.nrrd", volume_of(text_volume("3", "600"), "float"));
    write("flat.nrrd", volume_of(text_volume("7", "7")));
    write("labels.nrrd", volume_of(text_volume("0", "2")));
    write("half.nrrd", volume_of(text_volume("0", "2.5"), "float"));
    write("mask.nrrd", volume_of(text_volume("0", "1")));
    write("two.nrrd", nrrd("type: short\nencoding: ascii\nspacings: 1 1 1 1\n", "6 5 4 2") + "\n" +
                          text_volume("0", "5") + text_volume("0", "9"));
    write("v.raw", std::string(3 * 60, '\0') + std::string(3 * 60, '\1'));
    write("patient.nrrd",
          nrrd("type: short\nencoding: ascii\nspace: LPS\nspace directions: (1,0,0) (0,1,0) "
               "(0,0,1)\n",
               "6 5 4") +
              "\n" + text_volume("10", "200"));
    done("extract v.nrrd --iso 100 -q -o v.dmc");
    done("extract v.nrrd --iso 100 -q -o v.stl");
  }
  void check_advice(const std::vector<Advice>& all) const {
    for (const Advice& each : all) {
      INFO(each.arguments, "\n", each.then);
      const Result refused = run(each.arguments);
      CHECK(refused.code != 0);
      INFO(refused.error);
      CHECK(contains(refused.error, each.advice));
      const Result followed = run(each.then);
      INFO(followed.error);
      CHECK(followed.code == 0);
    }
  }
};

}  // namespace

TEST_CASE_FIXTURE(Inputs, "every command that a message about an input advises succeeds") {
  const std::string out = " -q -o out.stl";
  check_advice(
      {{"extract two.nrrd --iso 5" + out, "choose one with --frame N, the first is 0",
        "extract two.nrrd --iso 5 --frame 1" + out},
       {"extract two.nrrd --iso 5 --frame 2" + out, "choose one with --frame 0 to 1",
        "extract two.nrrd --iso 5 --frame 0" + out},
       {"extract v.nrrd --iso 100 --series 1" + out, "leave out --series",
        "extract v.nrrd --iso 100" + out},
       {"extract v.nrrd --dims 6,5,4 --type i16 --iso 100" + out,
        "leave them out, or rename headerless samples to .raw", "extract v.nrrd --iso 100" + out},
       {"extract v.raw --dims 6,5,4 --type u8 --iso 1" + out, "give --dims 6,5,12",
        "extract v.raw --dims 6,5,12 --type u8 --iso 1" + out},
       {"extract v.dmc --iso 100" + out, "give it to discmc decode, info or render",
        "decode v.dmc -o out.stl"},
       {"decode v.nrrd -o out.stl", "give it to discmc extract, info or render", "info v.nrrd"},
       {"extract v.stl --iso 1 -q -o out.ply", "only discmc compare, render and view read meshes",
        "compare v.stl v.nrrd --iso 100"},
       {"extract v.nrrd --iso 100 --crop 9..,..,.." + out, "give a part of 0..5",
        "extract v.nrrd --iso 100 --crop 0..5,..,.." + out},
       {"extract half.nrrd --labels all -q -o out.glb", "give --iso or --range",
        "extract half.nrrd --iso 2.5" + out},
       {"extract half.nrrd --label 2" + out, "give --iso or --range",
        "extract half.nrrd --range 2.5.." + out},
       {"extract flat.nrrd --iso otsu" + out, "give --iso 7 to select them all",
        "extract flat.nrrd --iso 7" + out},
       {"extract mri.nrrd --iso bone" + out, "give a number or --iso otsu",
        "extract mri.nrrd --iso otsu" + out},
       {"extract v.nrrd --iso 900" + out, "or accept an empty surface with --allow-empty",
        "extract v.nrrd --iso 900 --allow-empty" + out},
       {"extract labels.nrrd --label 7" + out, "list the labels with discmc info",
        "info labels.nrrd"},
       {"extract labels.nrrd --labels 2,7 -q -o out.glb", "leave out these labels",
        "extract labels.nrrd --labels 2 -q -o out.glb"},
       {"extract labels.nrrd --labels 2,7 -q -o out.glb", "or give --allow-empty",
        "extract labels.nrrd --labels 2,7 --allow-empty -q -o out.glb"},
       {"extract labels.nrrd --label liver" + out, "give numbers, or --label-table FILE",
        "extract labels.nrrd --label 2" + out},
       {"extract v.nrrd --space lps --iso 100" + out, "leave out --space, or give --space voxel",
        "extract v.nrrd --space voxel --iso 100" + out},
       {"extract v.nrrd --iso 720575940621039145" + out,
        "if it is a label, give --label 720575940621039145",
        "extract v.nrrd --label 720575940621039145 --allow-empty" + out},
       {"extract v.nrrd --iso 100 --min-volume 1e9" + out,
        "give a smaller volume, or accept an empty surface with --allow-empty",
        "extract v.nrrd --iso 100 --min-volume 1" + out}});
  for (const std::string advised : {"v.nrrd", "v.raw --dims 6,5,12 --type u8"})
    CHECK(shell("cat " + advised.substr(0, 6) + " | \"$discmc\" extract - " + advised.substr(6) +
                " --iso auto" + out)
              .code == 1);
  CHECK(contains(shell("cat v.nrrd | \"$discmc\" extract - --iso auto" + out).error,
                 "can be read only once; store it in a file"));
}

TEST_CASE_FIXTURE(Inputs, "every command that a message about volumes in files advises succeeds") {
  write("colours.nrrd", nrrd("type: uchar\nencoding: ascii\nkinds: vector domain domain domain\n"
                             "spacings: nan 1 1 1\n",
                             "2 6 5 4") +
                            "\n" + text_volume("0", "5") + text_volume("0", "9"));
  write("v.npy", npy("|u1", "4, 5, 6", std::string(120, '\1')));
  write("times.npy", npy("|u1", "2, 4, 5, 6", std::string(240, '\1')));
  const std::string mask = std::string(30, '\0') + std::string(30, '\1');
  for (const std::string name : {"liver", "spleen"})
    write("masks/" + name + ".nii", Nifti().file(mask));
  const std::string out = " -q -o out.stl", iso = " --iso 5" + out;
  const std::string any = " --allow-empty" + iso;
  const std::string v = "extract v.nrrd --iso 100" + out;
  check_advice(
      {{"extract colours.nrrd" + iso, "choose one with --channel N, the first is 0",
        "extract colours.nrrd --channel 0" + any},
       {"extract colours.nrrd --channel 2" + iso, "choose one with --channel 0 to 1",
        "extract colours.nrrd --channel 1" + any},
       {v + " --channel 1", "leave out --channel", v},
       {v + " --frame 1", "leave out --frame", v},
       {v + " --axes zyx", "leave out --axes", v},
       {v + " --level 1", "leave out --level", v},
       {v + " --merge-series", "leave out --merge-series", v},
       {v + " --order name", "leave out --order", v},
       {"extract times.npy" + iso, "choose one with --frame N",
        "extract times.npy --frame 1" + any},
       {"extract times.npy" + iso, "name the axes of the array, 2 x 4 x 5 x 6, with --axes",
        "extract times.npy --axes czyx --channel 1" + any},
       {"extract v.npy --axes yx" + iso, "name each axis with --axes, as in --axes zyx",
        "extract v.npy --axes zyx" + any},
       {"extract masks" + iso, "name one file", "extract masks/liver.nii --iso auto" + out},
       {"extract masks" + iso, "read each file as a label with --labels all",
        "extract masks --labels all -q -o out.glb"},
       {"extract masks" + iso, "or --label NAME", "extract masks --label spleen" + out},
       {"extract masks --frame 2 --iso 1" + out, "choose one with --frame 0 to 1",
        "extract masks --frame 1 --iso 1" + out},
       {"extract two.nrrd --label 9" + out, "choose one with --frame N",
        "extract two.nrrd --frame 1 --label 9" + out},
       {"extract v.raw --dims 6,5,12 --type i32 --iso 1" + out, "give --type u8",
        "extract v.raw --dims 6,5,12 --type u8 --iso 1" + out}});
  const std::string head = nrrd("type: uchar\nencoding: raw\n", "6 5 4") + "\n";
  write("named.raw", head + std::string(120, '\1'));
  check_advice(
      {{"extract named.raw --dims 6,5,4 --type u8" + iso, "skip its header with --skip-bytes",
        "extract named.raw --dims 6,5,4 --type u8 --skip-bytes " + std::to_string(head.size()) +
            any}});
  write("masks/both.nii", Nifti().file(std::string(30, '\2') + std::string(30, '\1')));
  check_advice({{"extract masks --labels all -q -o out.glb", "give this file alone",
                 "extract masks/both.nii --labels all -q -o out.glb"}});
}

TEST_CASE_FIXTURE(Inputs, "every command that a message about options advises succeeds") {
  const std::string iso = "extract v.nrrd --iso 100 -q ";
  const std::string stl = iso + "-o out.stl ", ply = iso + "-o out.ply ", dmc = iso + "-o out.dmc ";
  const std::string all = "extract labels.nrrd --labels all -q ";
  check_advice(
      {{"extract v.nrrd -o out.stl", "add --iso auto, --iso ISO",
        "extract v.nrrd --iso auto -o out.stl"},
       {"tune v.nrrd", "add --iso auto, or", "tune v.nrrd --iso auto"},
       {"render v.nrrd -o out.png", "give --iso auto, or", "render v.nrrd --iso auto -o out.png"},
       {"compare v.nrrd v.stl", "give --iso auto, or", "compare v.nrrd v.stl --iso auto"},
       {all + "-o out.stl", "give -o 'FOLDER/{name}.stl'", all + "-o './{name}.stl'"},
       {all + "-o out.stl", ".glb or .3mf name, whose file holds all", all + "-o out.3mf"},
       {all + "-o '{name}.dmc'", "write meshes, or give --label",
        "extract labels.nrrd --label 2 -q -o out.dmc"},
       {all + "-o out.glb --mask mask.nrrd --median 3",
        "leave out --median, or give each label by --label",
        "extract labels.nrrd --label 2 --mask mask.nrrd --median 3 --allow-empty -q -o out.glb"},
       {iso + "--iso 50 -o out.stl", "in -o 'surface-{name}.stl', or give a .glb or .3mf name",
        iso + "--iso 50 -o 'surface-{name}.stl'"},
       {dmc + "--iso 1 --iso 2 --iso 3 --iso 4", "give 4 at most",
        dmc + "--iso 1 --iso 2 --iso 3 --allow-empty"},
       {stl + "--label-table t.txt", "add --label N or --labels all",
        "extract labels.nrrd --label 2 -q -o out.stl"},
       {stl + "--normals surface", "cannot hold normals; give ", ply + "--normals surface"},
       {dmc + "--normals surface", "give --normals gradient", dmc + "--normals gradient"},
       {stl + "--faces polygons", "leave it out, or give a .ply", ply + "--faces polygons"},
       {dmc + "--largest 1", "write a mesh", stl + "--largest 1"},
       {"extract patient.nrrd --iso 100 --space ras -q -o out.dmc", "leave it out, or write a mesh",
        "extract patient.nrrd --iso 100 --space ras -q -o out.stl"},
       {stl + "--largest 1 --border open",
        "leave out --largest, --min-volume and --fill, or --border open", stl + "--border open"},
       {ply + "--mask mask.nrrd --normals gradient", "give --normals surface",
        ply + "--mask mask.nrrd --normals surface"},
       {"extract v.nrrd --range 100..250 -q -o out.ply --normals gradient",
        "give --normals surface",
        "extract v.nrrd --range 100..250 -q -o out.ply --normals surface"},
       {stl + "--surface interpolated --median 3",
        "with --surface interpolated, as the samples are not filtered; leave one out",
        stl + "--median 3"},
       {stl + "--surface interpolated --faces polygons", "leave it out",
        stl + "--surface interpolated"},
       {stl + "--surface interpolated --no-conforming", "leave it out",
        stl + "--surface interpolated"},
       {"extract labels.nrrd --label 2 --surface interpolated -q -o out.stl", "add --smooth auto",
        "extract labels.nrrd --label 2 --surface interpolated --smooth auto -q -o out.stl"},
       {all + "-o out.glb --surface interpolated", "add --smooth auto",
        all + "-o out.glb --surface interpolated --smooth auto"},
       {iso + "--iso 50 --smooth auto -o '{name}.stl'", "or --labels; run discmc once per surface",
        stl + "--smooth auto"},
       {ply + "--smooth auto --normals gradient", "give --normals surface",
        ply + "--smooth auto --normals surface"},
       {stl + "--smooth auto --median 3", "leave one out", stl + "--smooth auto"},
       {iso + "--surface interpolated -o out.jsonl",
        "leave out --surface interpolated, or write a mesh", stl + "--surface interpolated"},
       {stl + "--tolerance 0.1", "add --surface interpolated",
        stl + "--tolerance 0.1 --surface interpolated"},
       {dmc + "--median 3 --normals gradient",
        "with --normals gradient in a stream, as the samples are not filtered; leave one out",
        dmc + "--median 3"},
       {stl + "--wire slices", "give -o FILE.dmc", dmc + "--wire slices"},
       {dmc + "--wire slices --normals gradient", "leave out --normals", dmc + "--wire slices"},
       {dmc + "--wire slices --memory 1M", "leave out --memory and --capacities",
        dmc + "--wire slices"},
       {dmc + "--key-slices 2", "add --wire slices", dmc + "--key-slices 2 --wire slices"},
       {stl + "--slab 1/2", "give -o FILE.dmc, without --wire slices", dmc + "--slab 1/2"},
       {dmc + "--slab 1/2 --iso 50", "give one --iso, --range or --label", dmc + "--slab 1/2"},
       {dmc + "--slab 1/2 --normals gradient", "leave out --normals", dmc + "--slab 1/2"},
       {dmc + "--slab 1/9", "the volume has 4 slices; give that many slabs at most",
        dmc + "--slab 1/4"},
       {dmc + "--jobs 2 --memory 1M", "leave one out", dmc + "--jobs 2"},
       {iso + "-o 'out-{nam}.stl'", "only {name} is supported", iso + "-o 'out-{name}.stl'"},
       {iso + "-o '{name}/out.stl'", "put it after the last /", iso + "-o './{name}.stl'"},
       {iso + "-o out.xyz", "use ", ply},
       {dmc + "--memory 10", "give at least ", dmc + "--memory 64K"},
       {dmc + "--capacities 1,1", "invalid number of slots; expected 4 to",
        dmc + "--capacities 4,1"},
       {"decode v.dmc --volume v.nrrd -o out.ply", "used with --normals gradient alone",
        "decode v.dmc --volume v.nrrd --normals gradient -o out.ply"},
       {"decode v.dmc --normals gradient -o out.ply",
        "with --volume FILE, or give --normals surface",
        "decode v.dmc --normals surface -o out.ply"},
       {"decode v.dmc --stream-channel 3 -o out.ply",
        "the stream has no such surface; choose one of ", "decode v.dmc -o out.ply"},
       {"render v.dmc --view 0,0,0 -o out.png", "give another vector",
        "render v.dmc --view 1,0,0 -o out.png"},
       {"render v.dmc --iso 5 -o out.png", "leave it out", "render v.dmc -o out.png"},
       {"render v.dmc -o out.jpg", "give a name that ends in .png", "render v.dmc -o out.png"}});
  for (const std::string slab : {"1", "2"}) done(iso + "--slab " + slab + "/2 -o " + slab + ".dmc");
  check_advice(
      {{"join 1.dmc 2.dmc 2.dmc -o out.dmc", "give every slab once", "join 1.dmc 2.dmc -o out.dmc"},
       {"join 1.dmc 2.dmc -o out.dmc --memory x",
        "expected a whole number with K, M or G, as in 24K",
        "join 1.dmc 2.dmc -o out.dmc --memory 24K"}});
  check_advice({{iso + "-o 'none/{name}.stl'", "the folder does not exist; create it",
                 iso + "-o 'out-{name}.stl'"}});
  REQUIRE(shell("mkdir none").code == 0);
  done(iso + "-o 'none/{name}.stl'");
}

TEST_CASE_FIXTURE(Inputs, "every command that a message of view about pages advises succeeds") {
  if (discmc::command::page_template().empty()) return;
  check_advice({{"view v.nrrd --no-open --median 3 -o out.html", "add --iso auto",
                 "view v.nrrd --no-open --median 3 --iso auto -o out.html"},
                {"view - --no-open", "give -o PAGE.html", "view v.dmc --no-open -o page.html"}});
  write("v.html", "no page of discmc");
  check_advice(
      {{"view v.dmc --no-open", "overwrite it with -o v.html", "view v.dmc --no-open -o v.html"}});
}
