// discmc extract --labels all, and tables of labels.
#include "command.hpp"
#include "pictures/srgb.hpp"

namespace {

using namespace command_tests;
using discmc::command::label_colour;
using discmc::command::Srgb;

const std::string extract = "extract v.raw --dims 4,2,3 --type u8 --spacing 1,1,1 ";

// A body of label 1, two bodies of label 2, and a voxel of label 9.
const std::string volume("\1\1\0\2\1\1\0\0\1\1\0\0\0\0\0\0\0\0\x9\2\0\0\0\2", 24);

// A body of label 1 at voxels that have other labels in the first layer.
const std::string second_layer("\0\0\1\1\0\1\1\0\0\0\1\1\0\1\1\0\0\0\0\0\0\0\0\0", 24);

// Both volumes as layers of one segmentation. A list is the first axis.
std::string layered() {
  std::string samples;
  for (std::size_t i = 0; i < volume.size(); ++i) samples += {volume[i], second_layer[i]};
  return "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 4 2 3\n"
         "space directions: none (1,0,0) (0,1,0) (0,0,2)\nkinds: list domain domain domain\n"
         "encoding: gzip\nspace origin: (-20,-30,40)\n"
         "Segment0_Color:=0.5 1 0\nSegment0_Layer:=0\nSegment0_Name:=Bone\n"
         "Segment0_LabelValue:=1\nSegment1_Layer:=1\nSegment1_Name:=Skin\n"
         "Segment1_LabelValue:=1\nSegment2_Layer:=0\nSegment2_Name:=Tee/th\n"
         "Segment2_LabelValue:=2\nSegment3_Name:=nine\nSegment3_LabelValue:=9\n\n" +
         volume_files::gzip(samples);
}

std::string with_line(std::string file, const std::string& line, const std::string& other) {
  return file.replace(file.find(line), line.size(), other);
}

struct LabelVolume : Workshop {
  LabelVolume() { write("v.raw", volume); }
};

}  // namespace

TEST_CASE_FIXTURE(LabelVolume, "--labels all writes for each label the mesh that --label writes") {
  REQUIRE(shell("mkdir out").code == 0);
  const std::string output = done(extract + "--labels all -o 'out/{name}.stl'");
  for (const std::string label : {"1", "2", "9"}) {
    CHECK(contains(output, "  out/" + label + ".stl\n"));
    done(extract + "--label " + label + " -o alone.stl");
    CHECK(read("out/" + label + ".stl") == read("alone.stl"));
  }
  CHECK(shell("ls out").out == "1.stl\n2.stl\n9.stl\n");
  CHECK(contains(output, "       2             3"));
  CHECK(done(extract + "--labels all -q -o '{name}.stl'").empty());
}

TEST_CASE_FIXTURE(LabelVolume,
                  "label names that are paths cannot write outside the output folder") {
  write("table.txt", "1 ../../bone 1 2 3\n2 .. 4 5 6\n9 /tmp/bone 7 8 9\n");
  REQUIRE(shell("mkdir out").code == 0);
  done(extract + "--labels all --label-table table.txt -o 'out/{name}.stl'");
  CHECK(shell("LC_ALL=C ls out").out == "_...stl\n_.._.._bone.stl\n_tmp_bone.stl\n");
}

TEST_CASE_FIXTURE(LabelVolume, "a label table in Latin-1 gives file names in UTF-8") {
  write("table.txt", "1 \xc6rea 1 2 3\n");
  done(extract + "--label \xc3\x86rea --label-table table.txt -q -o '{name}.stl'");
  CHECK(shell("ls").out.find("\xc3\x86rea.stl") != std::string::npos);
}

TEST_CASE_FIXTURE(LabelVolume, "a label table that names no label of the volume is reported") {
  write("table.txt", "77 bone 1 2 3\n");
  check_parts(run(extract + "--labels all --label-table table.txt -q -o '{name}.stl'"), 0,
              {"no label of the volume has a name in --label-table"});
  fails(extract + "--labels 0,1 -o '{name}.stl'", 1,
        {"--labels has 0, which is the background", "--label 0 for its surface"});
}

TEST_CASE_FIXTURE(LabelVolume, "a label table names the meshes of labels") {
  write("table.txt", "0 Background 0 0 0\n1 bone 1 2 3\n2 skin 4 5 6\n9 bone 7 8 9\n");
  done(extract + "--labels all --label-table table.txt -o '{name}.ply'");
  done(extract + "--label 9 --label 7 --allow-empty --label-table table.txt -o 'one-{name}.ply'");
  CHECK(read("bone-9.ply") == read("one-bone.ply"));
  CHECK_FALSE(read("one-7.ply").empty());
  CHECK(mesh_in("bone.ply").colour == Srgb{1, 2, 3});
  CHECK(mesh_in("skin.ply").colour == Srgb{4, 5, 6});
}

TEST_CASE_FIXTURE(LabelVolume,
                  "OBJ has a label's colour in a material file, and VTP in the mesh file") {
  write("table.txt", "1 bone 51 102 255\n");
  const std::string label = extract + "--labels 1 --label-table table.txt ";
  done(label + "-o 'my {name}.obj'");
  CHECK(contains(read("my bone.obj"), "\nmtllib my_bone.mtl\nusemtl surface\nv "));
  CHECK(read("my_bone.mtl") == "newmtl surface\nKd 0.2 0.4 1\n");
  CHECK(contains(run(label + "-o '{name}.obj' && cat bone.mtl").out, "bone.obj"));
  done(label + "--normals surface -o '{name}.vtp'");
  CHECK(mesh_in("bone.vtp").colour == Srgb{51, 102, 255});
  done(extract + "--iso 1 -o plain.obj");
  CHECK_FALSE(contains(read("plain.obj"), "mtllib"));
  const std::vector<std::string> names = file_names();
  CHECK(std::count(names.begin(), names.end(), "plain.mtl") == 0);
}

TEST_CASE_FIXTURE(LabelVolume,
                  "OBJ labels whose names differ only in spaces have separate materials") {
  write("table.txt", "1 my_bone 51 102 255\n2 \"my bone\" 255 0 0\n");
  done(extract + "--labels 1,2 --label-table table.txt -o '{name}.obj'");
  CHECK(contains(read("my_bone.obj"), "\nmtllib my_bone.mtl\n"));
  CHECK(read("my_bone.mtl") == "newmtl surface\nKd 0.2 0.4 1\n");
  CHECK(contains(read("my bone-2.obj"), "\nmtllib my_bone-2.mtl\n"));
  CHECK(read("my_bone-2.mtl") == "newmtl surface\nKd 1 0 0\n");
  done(extract + "--labels 1,2 --label-table table.txt -o '{name}.ply'");
  CHECK_FALSE(read("my bone.ply").empty());
}

TEST_CASE_FIXTURE(Workshop, "without a table, segments of 3D Slicer name the meshes of labels") {
  write("v.seg.nrrd",
        "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 2 3\nencoding: raw\n"
        "Segment0_Color:=0.5 1 0\nSegment0_ID:=a\nSegment0_LabelValue:=2\n"
        "Segment0_Name:=left lung/top\nSegment10_LabelValue:=1\nSegment10_Name:=bone\n"
        "Segment10_Color:=1 2 3\nSegmentation_MasterRepresentation:=Binary labelmap\n"
        "Segment1_LabelValue:=none\nSegment1_Name:=lost\n\n" +
            volume);
  done("extract v.seg.nrrd --labels all -o '{name}.ply'");
  const auto colour = [&](const std::string& name) { return mesh_in(name).colour; };
  CHECK(colour("left lung_top.ply") == Srgb{128, 255, 0});
  CHECK_FALSE(read("bone.ply").empty());
  CHECK(colour("bone.ply") == label_colour(1));
  CHECK(colour("9.ply") == label_colour(9));
  write("table.txt", "1 tibia 1 2 3\n");
  done("extract v.seg.nrrd --labels all --label-table table.txt -o 'own-{name}.ply'");
  CHECK_FALSE(read("own-tibia.ply").empty());
  CHECK_FALSE(read("own-2.ply").empty());
}

TEST_CASE_FIXTURE(Workshop, "overlapping segments of 3D Slicer are read from all layers") {
  write("layers.seg.nrrd", layered());
  const std::string output = done("extract layers.seg.nrrd --labels all -o '{name}.ply'");
  write("v.raw", volume);
  write("w.raw", second_layer);
  const auto alone = [&](const std::string& file, const std::string& label) {
    done("extract " + file + " --dims 4,2,3 --type u8 --label " + label + " -o alone.jsonl");
    return read("alone.jsonl");
  };
  const auto layer = [&](const std::string& label) {
    done("extract layers.seg.nrrd --label '" + label + "' -o l.jsonl");
    return read("l.jsonl");
  };
  CHECK(contains(output, "       1             6"));
  CHECK(mesh_in("Bone.ply").colour == Srgb{128, 255, 0});
  CHECK_FALSE(read("Tee_th.ply").empty());
  CHECK(layer("Bone") == alone("v.raw", "1"));
  CHECK(layer("Tee/th") == alone("v.raw", "2"));
  CHECK(layer("Skin") == alone("w.raw", "1"));
  CHECK(layer("skin") == alone("w.raw", "1"));
  CHECK(layer("9") == alone("v.raw", "9"));
  // In the space of the file.
  const FileMesh skin = mesh_in("Skin.ply");
  for (const Point& vertex : skin.vertices_mm) CHECK(vertex[2] >= 39);
  std::string both = volume;
  for (std::size_t i = 0; i < both.size(); ++i)
    both[i] = static_cast<char>(volume[i] == 2 || second_layer[i] == 1 ? 1 : 0);
  write("both.raw", both);
  CHECK(layer("Tee/th,Skin") == alone("both.raw", "1"));
  done("extract layers.seg.nrrd --labels 'Skin,Tee/th' -q -o 'some-{name}.ply'");
  CHECK(read("some-Skin.ply") == read("Skin.ply"));
  CHECK(read("some-Tee_th.ply") == read("Tee_th.ply"));
  CHECK(read("some-Bone.ply").empty());
  // A file with one layer is read as before.
  CHECK(contains(done("extract layers.seg.nrrd --labels all --frame 1 -o 'f-{name}.ply'"),
                 "f-Skin.ply"));
  CHECK(read("f-Bone.ply").empty());
}

TEST_CASE_FIXTURE(
    Workshop,
    "segmentation layers are listed, and refused if one layer does not hold all requested labels") {
  write("layers.seg.nrrd", layered());
  const std::string info = done("info layers.seg.nrrd");
  for (const char* line : {"frames 2", "label 1 layer 0 Bone", "label 1 layer 1 Skin",
                           "note the values are those of layer 0; choose"})
    CHECK(contains(info, line));
  CHECK(contains(done("info layers.seg.nrrd --frame 1"), "range 0 1\n"));
  fails("extract layers.seg.nrrd --iso 1 -o v.stl", 1,
        {"the file holds labels in 2 volumes", "select labels with --label NAME"});
  fails("extract layers.seg.nrrd --label 1 -o v.stl", 1,
        {"label 1 is 'Bone' and, in another layer, 'Skin'"});
  check_failure(shell("\"$discmc\" extract - --labels all -q -o v.glb < layers.seg.nrrd"), 1,
                {"standard input: each layer of a segmentation is read separately"});
  write("wrong.seg.nrrd", with_line(layered(), "Segment1_Layer:=1", "Segment1_Layer:=2"));
  check_parts(
      run("extract wrong.seg.nrrd --labels all -q -o w.glb"), 0,
      {"segments of layers that are not in the file are left out: 1, such as 'Skin' of layer 2",
       "1 of 2 layers have no label in the header"});
  write("share.seg.nrrd", with_line(layered(), "type: uchar",
                                    "type: uchar\nSegmentation_SourceRepresentation:="
                                    "Fractional labelmap"));
  fails("extract share.seg.nrrd --labels all -o w.glb", 1, {"the file holds 2 volumes"});
}

TEST_CASE_FIXTURE(Workshop,
                  "a 3D Slicer segmentation without label values has a layer per segment") {
  std::string old = layered();
  for (const char* key : {"Segment0_Layer:=0\n", "Segment1_Layer:=1\n", "Segment0_LabelValue:=1\n",
                          "Segment1_LabelValue:=1\n"})
    old.erase(old.find(key), std::string(key).size());
  write("old.seg.nrrd", old);
  const std::string output = done("extract old.seg.nrrd --label Skin -o old.jsonl");
  write("layers.seg.nrrd", layered());
  done("extract layers.seg.nrrd --label Skin -o v.jsonl");
  CHECK(read("old.jsonl") == read("v.jsonl"));
}

TEST_CASE_FIXTURE(Workshop, "a label value that several segments share has no name") {
  write("one.seg.nrrd",
        "NRRD0005\ntype: uchar\nencoding: raw\ndimension: 3\nsizes: 4 2 3\n"
        "Segment0_Name:=Bone\nSegment0_LabelValue:=1\nSegment1_Name:=Skin\n"
        "Segment1_LabelValue:=1\nSegment2_Name:=Teeth\nSegment2_LabelValue:=2\n\n" +
            volume);
  const auto one = done("extract one.seg.nrrd --labels all -o 'one-{name}.stl'");
  CHECK(contains(one, "one-1.stl"));
  CHECK(contains(one, "one-Teeth.stl"));
}

TEST_CASE_FIXTURE(Workshop, "the extension of TotalSegmentator in NIfTI names its labels") {
  const std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension>  <VolumeInformation "
      "Index=\"0\"> "
      "<LabelTable>\n<Label Key=\"1\" Red=\"1.0\" Green=\"0.5\" Blue=\"0\" Alpha=\"1\">"
      "<![CDATA[liver]]></Label>\n<Label Key=\"2\"><![CDATA[right lung]]></Label>"
      "</LabelTable></VolumeInformation></CaretExtension>\n        ";
  const auto nifti = [&](bool is_big_endian, std::vector<std::pair<int, std::string>> extensions) {
    std::string bytes;
    for (auto& [code, content] : extensions) {
      content.resize((content.size() + 8 + 15) / 16 * 16 - 8, '\0');
      for (const int word : {static_cast<int>(content.size()) + 8, code})
        for (int i = 0; i < 4; ++i)
          bytes += static_cast<char>(word >> 8 * (is_big_endian ? 3 - i : i) & 0xff);
      bytes += content;
    }
    volume_files::Nifti header(is_big_endian);
    header.dims({3, 4, 2, 3}).real(108, static_cast<float>(352 + bytes.size()));
    std::string file = header.file(bytes + volume);
    file[348] = 1;
    return file;
  };
  for (const bool is_big_endian : {false, true})
    for (const int code : {0, 6, 30}) {
      INFO(is_big_endian, code);
      write("v.nii", nifti(is_big_endian, {{4, "<AFNI/>"}, {code, xml}}));
      done("extract v.nii --labels all -q -o '{name}.ply'");
      CHECK(mesh_in("liver.ply").colour == Srgb{255, 128, 0});
      done("extract v.nii --label 'right lung,9' -q -o v.stl");
      done("extract v.nii --label 2,9 -q -o w.stl");
      CHECK(read("v.stl") == read("w.stl"));
      CHECK(contains(done("info v.nii"), "label 2 right lung\n"));
    }
  // Another extension is ignored, and the samples remain at their offset.
  std::string cut = nifti(false, {{0, xml}});
  cut[352] = '\x7f';
  cut[354] = '\x7f';
  for (const std::string& file :
       {nifti(false, {{0, "<CaretExtension>"}}), nifti(false, {{2, xml}}), cut}) {
    write("v.nii", file);
    CHECK(contains(done("extract v.nii --labels all -o 'no-{name}.stl'"), " no-1.stl\n"));
  }
}

TEST_CASE_FIXTURE(
    Workshop, "a folder or pattern of masks is read as one label per file, named after the file") {
  const auto mask = [&](const std::string& samples) {
    return volume_files::gzip(volume_files::Nifti().dims({3, 4, 2, 3}).file(samples));
  };
  std::string bone, lung;
  for (std::size_t i = 0; i < volume.size(); ++i) {
    bone += static_cast<char>(volume[i] == 1 ? 255 : 0);
    lung += static_cast<char>(second_layer[i]);
  }
  write("seg/bone.nii.gz", mask(bone));
  write("seg/lung left.nii.gz", mask(lung));
  write("seg/spleen.nii.gz", mask(std::string(24, '\0')));
  write("seg/spleen.nii", mask(std::string(24, '\0')));
  fails(
      "extract seg --labels all -o m.glb", 1,
      {"two files are the mask 'spleen': 'spleen.nii' and 'spleen.nii.gz'; move one of them away"});
  REQUIRE(shell("rm seg/spleen.nii").code == 0);
  write("seg/._bone.nii.gz", "of macOS");
  write("seg/statistics.json", "{}");
  write("v.raw", volume);
  write("w.raw", second_layer);
  done(extract + "--label 1 -q -o bone.stl");
  done("extract w.raw --dims 4,2,3 --type u8 --label 1 -q -o lung.stl");
  for (const std::string input : {"seg", "seg/", "'seg/*.nii.gz'"}) {
    INFO(input);
    check_parts(run("extract " + input + " --labels all -o 'all-{name}.stl'"), 0,
                {"no voxel has spleen\n"});
    CHECK(read("all-bone.stl") == read("bone.stl"));
    CHECK(read("all-lung left.stl") == read("lung.stl"));
    CHECK_FALSE(contains(shell("ls").out, "spleen"));
  }
  done("extract seg --label 'lung left' -q -o v.stl");
  CHECK(read("v.stl") == read("lung.stl"));
  done("extract seg --label bone --label 'lung left,bone' -q -o v.dmc");
  done("decode v.dmc --stream-channel 0 -o v.stl");
  CHECK(read("v.stl") == read("bone.stl"));
  CHECK(contains(done("info seg"), "label nonzero layer 1 lung left\n"));
  done("extract seg/bone.nii.gz --iso 1 -q -o v.stl");
  CHECK(read("v.stl") == read("bone.stl"));
  fails("extract seg --iso 1 -o v.stl", 1,
        {"seg: several volumes: 3, such as ", "--labels all or --label NAME"});
  fails("extract seg --labels spleen -o v.glb", 1, {"no voxel has spleen"});
  fails("extract seg --label 1 -o v.glb", 1, {"no label has the number 1"});
}

TEST_CASE_FIXTURE(Workshop,
                  "masks of other scans, and label maps, are refused in a folder of masks") {
  const auto nifti = [] { return volume_files::Nifti().dims({3, 4, 2, 3}); };
  write("seg/a.nii", nifti().file(second_layer));
  const auto refused = [&](const std::string& file, const std::string& part) {
    write("seg/b.nii", file);
    fails("extract seg --labels all -o v.glb", 1, {"seg/b.nii: ", part});
  };
  refused(nifti().file(volume), "the values 1 and 2 are in the file");
  refused(nifti().dims({3, 2, 4, 3}).file(second_layer), "has 2 x 4 x 3 voxels, and 'a.nii' 4 x 2");
  refused(nifti().real(80, 2).file(second_layer), "the mask lies elsewhere than 'a.nii'");
  refused(nifti().scale(0.5F, 0).file(second_layer), "the value 0.5 in slice 0 is no label");
  // A single file is read as a volume.
  REQUIRE(shell("rm seg/a.nii").code == 0);
  write("seg/b.nii", nifti().file(volume));
  CHECK(contains(done("extract seg --labels all -o v.glb"), "  9\n"));
}

TEST_CASE_FIXTURE(LabelVolume,
                  "a missing label in --labels fails the command, unless --allow-empty is given") {
  write("table.json", R"({"labels": {"background": 0, "bone": 1, "skin": [2, 9]}})");
  done(extract + "--labels 9,1 -q -o 'some-{name}.stl'");
  done(extract + "--labels all -q -o '{name}.stl'");
  CHECK(read("some-1.stl") == read("1.stl"));
  CHECK(read("some-9.stl") == read("9.stl"));
  CHECK(read("some-2.stl").empty());
  fails(extract + "--labels 1,7,8 -o 'x-{name}.stl'", 1,
        {"v.raw: no voxel has label 7, label 8; leave out these labels"});
  check_parts(run(extract + "--labels 1,7 --allow-empty -q -o 'x-{name}.stl'"), 0,
              {"no voxel has label 7\n"});
  const std::string named = extract + "--label-table table.json ";
  done(named + "--label skin -q -o skin.stl");
  done(extract + "--label 2,9 -q -o union.stl");
  CHECK(read("skin.stl") == read("union.stl"));
  done(named + "--labels skin -q -o 'region-{name}.stl'");
  CHECK(read("region-skin.stl") == read("union.stl"));
  fails(extract + "--labels '' -o v.glb", 2, {"no label is given"});
  fails(extract + "--label '' -o v.stl", 2, {"invalid value ''; expected a number or name"});
  fails(extract + "--label 7 -o v.stl", 1,
        {"v.raw: no voxel has label 7; list the labels with discmc info"});
}

TEST_CASE_FIXTURE(Workshop, "floating-point labels are rounded, with a note") {
  std::string samples;
  for (const char label : volume)
    samples += volume_files::bytes_of(static_cast<float>(label) * 1.001F);
  write("f.raw", samples);
  write("v.raw", volume);
  for (const std::string labels : {"--label 9", "--labels 9"}) {
    INFO(labels);
    const auto rounded = run("extract f.raw --dims 4,2,3 --type f32 -q -o f.glb " + labels);
    CHECK(rounded.code == 0);
    CHECK(contains(rounded.error,
                   "discmc: f.raw: 10 values are rounded to whole numbers, as labels are; the "
                   "farthest is 9.009"));
    done(extract + "-q -o v.glb " + labels);
    CHECK(read("f.glb") == read("v.glb"));
  }
  CHECK(contains(done("info f.raw --dims 4,2,3 --type f32"), "proposal --label N: one of 1 2 9\n"));
}

TEST_CASE_FIXTURE(
    Workshop,
    "64-bit labels are exact; as thresholds, values that double cannot represent are refused") {
  std::string samples;
  for (const char label : volume)
    samples += volume_files::bytes_of(
        label == 0 ? 0 : 720575940621039144 + static_cast<std::uint64_t>(label));
  write("ids.raw", samples);
  write("v.raw", volume);
  const std::string ids = "ids.raw --dims 4,2,3 --type u64 ";
  CHECK(contains(done("extract " + ids + "--labels all -o '{name}.stl'"),
                 "720575940621039146             3"));
  done("extract " + ids + "--label 720575940621039146 -q -o one.stl");
  done(extract + "--label 2 -q -o two.stl");
  CHECK(read("one.stl") == read("two.stl"));
  CHECK(read("720575940621039146.stl") == read("two.stl"));
  const std::string info = done("info " + ids);
  CHECK(contains(info, "range 0 720575940621039153\n"));
  CHECK(contains(info,
                 "proposal --label N: one of 720575940621039145 720575940621039146 "
                 "720575940621039153\n"));
  CHECK(contains(info, "histogram 720575940621039146 720575940621039146           3 "));
  for (const std::string threshold : {"--iso 720575940621039146", "--range ..720575940621039145"})
    fails("extract " + ids + threshold + " -o v.stl", 2, {"of a threshold"});
  done("extract " + ids + "--iso 720575940621039104 -q -o all.stl");
}

TEST_CASE_FIXTURE(LabelVolume, "GLB and 3MF hold all meshes with names and colours") {
  write("table.txt", "1 a<&\xC3\xA4\xFF 1 2 3\n2 skin 4 5 6\n9 skin 7 8 9\n");
  const std::string options = " --label-table table.txt ";
  done(extract + "--labels all -o '{name}.ply'");
  for (const std::string file : {"all.glb", "all.3mf"}) {
    INFO(file);
    const std::string output = done(extract + "--labels all" + options + "-o " + file);
    CHECK(contains(output, "  skin\n"));
    CHECK(contains(output, file + ": "));
    const auto all = meshes_in(file);
    REQUIRE(all.size() == 3);
    const std::string labels[] = {"1", "2", "9"};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto alone = mesh_in(labels[i] + ".ply");
      CHECK(all[i].corners == alone.corners);
      REQUIRE(all[i].vertices_mm.size() == alone.vertices_mm.size());
      for (std::size_t v = 0; v < alone.vertices_mm.size(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
          CHECK(all[i].vertices_mm[v][axis] == doctest::Approx(alone.vertices_mm[v][axis]));
    }
    CHECK(all[0].name == "a<&\xC3\xA4\xEF\xBF\xBD");
    CHECK(all[2].name == "skin");
    CHECK(all[0].colour == Srgb{1, 2, 3});
    CHECK(all[2].colour == Srgb{7, 8, 9});

    done(extract + "--label 2 --label 9 -o " + file);
    const auto two = meshes_in(file);
    REQUIRE(two.size() == 2);
    CHECK(two[0].name == "2");
    CHECK(two[1].corners == all[2].corners);

    const auto result = run(extract + "--labels all --median 3 -q -o " + file);
    CHECK(contains(result.error, "label 9 has no surface; " + file + " does not contain it"));
    CHECK(meshes_in(file).size() == 1);
    fails(extract + "--labels all -q --min-volume 99 -o no" + file, 1,
          {"no label has a surface left, so no" + file + " is not written"});
    CHECK(read("no" + file).empty());
  }
  for (const std::string file : {"all.stl", "all.ply", "all.obj", "all.vtp", "all.jsonl"})
    fails(extract + "--label 2 --label 9 -o " + file, 2, {"--output", "{name}", ".glb or .3mf"});
}

TEST_CASE_FIXTURE(
    LabelVolume,
    "a label without a surface is reported by name, and no file is written for the label") {
  for (const std::string cleaning : {"--median 3", "--min-volume 4"}) {
    INFO(cleaning);
    const auto result = run(extract + "--labels all " + cleaning + " -q -o '{name}.stl'");
    CHECK(result.code == 0);
    CHECK(contains(result.error, "label 9 has no surface; 9.stl is not written"));
    CHECK(read("9.stl").empty());
  }
  done(extract + "--labels all --median 3 --allow-empty -q -o '{name}.stl'");
  CHECK_FALSE(read("9.stl").empty());
}

TEST_CASE_FIXTURE(LabelVolume,
                  "GLB and 3MF files of several labels omit labels without triangles") {
  for (const std::string file : {"all.glb", "all.3mf"}) {
    INFO(file);
    done(extract + "--labels all --min-volume 1 --allow-empty -q -o " + file);
    const auto left = meshes_in(file);
    REQUIRE(left.size() == 1);
    CHECK(left[0].name == "1");
  }
}

TEST_CASE_FIXTURE(LabelVolume, "the note about --largest names the label that loses bodies") {
  write("table.txt", "1 bone 1 2 3\n2 skin 4 5 6\n");
  const std::string named = extract + "--label-table table.txt -q -o v.glb --largest 1 ";
  CHECK(run(named + "--labels all").error ==
        "discmc: v.raw: label 2 (skin): 1 of 2 bodies and cavities are kept\n");
  CHECK(run(named + "--label 1 --label 2").error ==
        "discmc: v.raw: skin: 1 of 2 bodies and cavities are kept\n");
}

TEST_CASE_FIXTURE(LabelVolume, "control characters in label names are not printed") {
  write("table.txt", "1 \x1b[31mred 1 2 3\n2 bell\a 4 5 6\n");
  for (const std::string labels : {"--labels all", "--label 1 --label 2"})
    for (const std::string file : {"v.glb", "v.3mf", "'{name}.stl'"}) {
      const auto result = run(extract + labels + " --label-table table.txt --largest 1 -o " + file);
      CHECK(contains(result.out, "_[31mred"));
      CHECK(contains(result.error, "bell_"));
      for (const std::string control : {"\x1b", "\a"})
        CHECK_FALSE(contains(result.out + result.error, control));
    }
}

TEST_CASE_FIXTURE(LabelVolume,
                  "label names too long for a file name are shortened and stay distinct") {
  std::string whole;
  for (int i = 0; i < 50; ++i) whole += "\xC3\xA4";
  const std::string name = whole + whole + whole;  // 300 bytes
  write("table.txt", "1 " + name + "1 1 2 3\n2 " + name + "2 4 5 6\n9 x" + name + " 1 1 1\n");
  done(extract + "--labels all --label-table table.txt -q -o 'v-{name}.stl'");
  for (const std::string& file : {whole, whole + "-2", "x" + whole.substr(2)}) {
    INFO(file);
    CHECK_FALSE(read("v-" + file + ".stl").empty());
  }
}

TEST_CASE_FIXTURE(LabelVolume,
                  "labels that the output cannot represent are refused before any work") {
  write("table.txt", "no table\n");
  write("nothing.raw", std::string(24, '\0'));
  write("half.raw", std::string(96, '\x3f'));  // 0.747...
  std::string nan;
  for (int i = 0; i < 24; ++i) nan += std::string("\0\0\xc0\x7f", 4);
  write("nan.raw", nan);
  write("nothing.nrrd", "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 2 3\nencoding: raw\n\n" +
                            std::string(24, '\0'));
  const std::string all = extract + "--labels all ";
  fails(all + "--iso 1 -o '{name}.stl'", 2, {"--labels", "--iso"});
  fails(all + "--memory 1M -o '{name}.stl'", 2, {"--labels", "--memory"});
  fails(all + "--normals gradient -o '{name}.ply'", 2, {"--normals"});
  fails(all + "--surface interpolated -o '{name}.ply'", 2, {"--surface"});
  fails(all + "--label-table table.txt -o '{name}.stl'", 1, {"table.txt", "line 1"});
  fails(extract + "--label 1 --label-table table.txt -o v.dmc", 1, {"table.txt", "line 1"});
  fails("extract nothing.raw --dims 4,2,3 --type u8 --labels all -o '{name}.stl'", 1,
        {"nothing.raw", "no label", "--allow-empty"});
  fails(all + "--mask nothing.nrrd -o '{name}.stl'", 1,
        {"v.raw: the volume holds no label within --mask; check --frame and --channel, or "
         "give --allow-empty"});
  fails("extract nan.raw --dims 4,2,3 --type f32 --labels all -o v.glb", 1,
        {"24 samples are not a number",
         "nan.raw: the volume holds no label; check --frame and --channel, or give --allow-empty"});
  fails("extract half.raw --dims 4,2,3 --type f32 --labels all -o '{name}.stl'", 1,
        {"half.raw", "slice 0", "whole numbers"});
  fails("extract half.raw --dims 4,2,3 --type f32 --label 1 -o v.stl", 1,
        {"half.raw", "slice 0", "whole numbers"});
}

TEST_CASE_FIXTURE(Workshop,
                  "a label without a colour gets a distinct default colour, equal in every file") {
  std::set<Srgb> colours;
  for (int number = 1; number <= 21; ++number) colours.insert(label_colour(number));
  CHECK(colours.size() == 21);
  CHECK(label_colour(-20) == label_colour(1));
  CHECK(label_colour(22) == label_colour(1));

  write("v.raw", volume);
  done(extract + "--labels all -o all.glb");
  done(extract + "--label 2 --label 9 -o two.glb");
  const auto all = meshes_in("all.glb"), two = meshes_in("two.glb");
  REQUIRE(all.size() == 3);
  REQUIRE(two.size() == 2);
  for (const std::size_t i : {0U, 1U, 2U})
    CHECK(all[i].colour == label_colour(std::stod(all[i].name)));
  CHECK(two[0].colour == all[1].colour);
  CHECK(two[1].colour == all[2].colour);
}
