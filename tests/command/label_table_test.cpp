// Tables of the names and colours of labels.
#include "volumes/label_table.hpp"

#include "volume_files.hpp"

namespace {

using namespace volume_files;
using discmc::command::read_label_table;
using discmc::command::Srgb;

// The rows by their first value.
using Labels = std::map<std::int64_t, discmc::command::LabelDescription>;

Labels table_of(const std::string& text) {
  const Folder folder;
  Labels labels;
  for (const auto& label : read_label_table(folder.write("table", text)))
    labels[std::stoll(label.values.at(0).text())] = label;
  return labels;
}

void check_no_table(const std::string& text, const std::string& part) {
  CHECK_THROWS_WITH_AS(table_of(text), doctest::Contains(part.c_str()), VolumeError);
}

void check_label(const discmc::command::LabelDescription& label, const std::string& name,
                 const std::optional<Srgb>& colour = {}) {
  CHECK(label.name == name);
  CHECK(label.colour == colour);
}

}  // namespace

TEST_CASE("label tables of 3D Slicer and FreeSurfer are read with names before colours") {
  const Labels table = table_of(
      "# Color table file\n\n0 Background 0 0 0 0\n1 Liver 221 130 101 255\r\n"
      "  17\tLeft-Hippocampus   220 216  20   0\n-3 unpainted\n");
  CHECK(table.size() == 4);
  check_label(table.at(1), "Liver", Srgb{221, 130, 101});
  check_label(table.at(17), "Left-Hippocampus", Srgb{220, 216, 20});
  check_label(table.at(-3), "unpainted");
}

TEST_CASE("label tables of ITK-SNAP are read with the name last, in quotes") {
  const Labels table = table_of(
      "# ITK-SnAP Label Description File\n"
      "    0     0    0    0        0  0  0    \"Clear Label\"\n"
      "    2     0  255    0        1  1  1    \"Left ventricle\"\n");
  CHECK(table.at(0).name == "Clear Label");
  check_label(table.at(2), "Left ventricle", Srgb{0, 255, 0});
}

TEST_CASE("a colour may precede or follow a quoted name in a label table") {
  const Labels table = table_of("12 \"Uber a\" 10 20 30 255\n3 \"liver\" 255 0 0\n4 \"bone\"\n");
  check_label(table.at(12), "Uber a", Srgb{10, 20, 30});
  CHECK(table.at(3).colour == Srgb{255, 0, 0});
  CHECK_FALSE(table.at(4).colour);
  CHECK(table_of("3 \"liver\" 255 0 0 255").at(3).colour == Srgb{255, 0, 0});
}

TEST_CASE("label tables of BIDS are read with columns in any order") {
  const Labels table = table_of(
      "name\tindex\tmapping\tcolor\nGray Matter\t1\t\t#ff53bB\nWhite "
      "Matter\t2\t7\nBone\t3\t\tn/a\n");
  check_label(table.at(1), "Gray Matter", Srgb{0xff, 0x53, 0xbb});
  check_label(table.at(2), "White Matter");
  CHECK_FALSE(table.at(3).colour);
  const Labels marked = table_of(
      "\xEF\xBB\xBF"
      "abbreviation\tindex\tname\n\t7\tkidney\r\n");
  CHECK(marked.at(7).name == "kidney");
}

TEST_CASE("coded terms replace missing names in a comma-separated label table of 3D Slicer") {
  const Labels table = table_of(
      "LabelValue,Name,Color_R,Color_G,Color_B,Color_A,Type_CodeMeaning,TypeModifier_CodeMeaning\n"
      "1,left_kidney,185,102,83,255,Kidney,Left\r\n"
      "5,,144,238,144,255,Kidney,Right\n"
      "10,\"artery, renal\",1,2,3,255,,\n11,bone,,,,,,\n");
  CHECK(table.size() == 4);
  check_label(table.at(1), "left_kidney", Srgb{185, 102, 83});
  CHECK(table.at(5).name == "Right Kidney");
  check_label(table.at(10), "artery, renal", Srgb{1, 2, 3});
  CHECK_FALSE(table.at(11).colour);
}

TEST_CASE("dataset.json of nnU-Net names labels in its old and its new form") {
  const Labels table = table_of(
      R"({"channel_names": {"0": "CT"}, "labels": {"background": 0, "liver": 1, "kidney": [2, 3],
          "id": 720575940621039145}, "numTraining": 3})");
  CHECK(table.size() == 4);
  CHECK(table.at(1).name == "liver");
  CHECK(table.at(2).name == "kidney");
  CHECK(table.at(2).values == std::vector<discmc::meshing::LabelValue>{2, 3});
  CHECK(table.at(720575940621039145).name == "id");
  const Labels first = table_of("\n {\"labels\": {\"0\": \"background\", \"2\": \"L\u00e4sion\"}}");
  CHECK(first.at(2).name == "L\xC3\xA4sion");
  check_no_table("{\"labels\": {\"liver\": 1}", "the file is not JSON");
  check_no_table("{\"label\": {}}", "no object \"labels\"");
  check_no_table("{\"labels\": [1]}", "no object \"labels\"");
  check_no_table("{\"labels\": {}}", "no object \"labels\"");
  check_no_table("{\"labels\": {\"liver\": 1.5}}", "label 'liver' is '1.5'");
  check_no_table("{\"labels\": {\"liver\": \"one\"}}", "label 'liver' is '\"one\"'");
  check_no_table("{\"labels\": {\"liver\": []}}", "label 'liver' is '[]'");
  check_no_table("{\"labels\": {\"liver\": [1, \"2\"]}}", "label 'liver' is");
}

TEST_CASE_FIXTURE(Folder, "an invalid line of a label table is refused with its line number") {
  check_no_table("1 bone\n\nskin 2\n", "line 3 is 'skin 2'");
  check_no_table("1\n", "line 1");
  check_no_table("1 2 3 4 5 6 7 \"open\n", "line 1");
  check_no_table("\"bone\" 1\n", "line 1");
  check_no_table("1 1 1 1 1 1 1 \"\"\n", "line 1");
  check_no_table("index\tname\n1\n", "line 2");
  check_no_table("99999999999999999999 bone\n", "line 1");
  check_no_table("1 bone\n1 skin\n", "label 1 is given twice; delete line 2");
  CHECK_THROWS_WITH_AS(read_label_table("/none/table"), doctest::Contains("/none/table"),
                       VolumeError);
  check_no_table("", "the table has no label");
  check_no_table("# nothing\n", "the table has no label");
  check_no_table("3 vena cava 1 2 3\n", "line 1");
  check_no_table("3 vein 1 2 300\n", "line 1");
  check_no_table("3 vein 0.1 0.2 0.3\n", "line 1");
  check_no_table("3 \"vein\" 1 2 300\n", "line 1");
  check_no_table("3 1 2 300 1 1 1 \"vein\"\n", "line 1");
  check_no_table("index\tname\tcolor\n1\tvein\t#zz0000\n", "line 2");
  check_no_table("LabelValue,Name\n1,\n", "line 2");
  check_no_table("LabelValue,Name,Color_R,Color_G,Color_B\n1,vein,1,2\n", "line 2");
  CHECK_THROWS_WITH_AS(read_label_table(path()), doctest::Contains("cannot be read"), VolumeError);
}
