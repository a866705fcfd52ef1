// Labels by numbers and names.
#include "volumes/label_names.hpp"

#include <stdexcept>

#include "test.hpp"

namespace {

using namespace discmc::command;

const LabelTable table = {{"liver", discmc::command::Srgb{1, 2, 3}, {1}},
                          {"Right_Lung", {}, {2}},
                          {"vein, portal", {}, {1}, 1},
                          {"twice", {}, {7}},
                          {"twice", {}, {8}},
                          {"7", {}, {9}},
                          {"region", {}, {2, 3}},
                          {"shared", {}, {5}},
                          {"also shared", {}, {5}},
                          {"mask", {}, {}, 2}};
const LabelNames names(table, {0, 1, 2});
const LabelNames first_layer(table, {0});

std::vector<LabelSet> sets_of(const std::vector<NamedLabels>& labels) {
  std::vector<LabelSet> sets;
  for (const NamedLabels& each : labels) sets.push_back(each.set);
  return sets;
}

void check_refused(const LabelNames& of, const std::string& list, const std::string& part) {
  INFO(list);
  CHECK_THROWS_WITH_AS(of.each(list), doctest::Contains(part.c_str()), std::invalid_argument);
}

}  // namespace

TEST_CASE("a list of labels accepts numbers and names, also names with commas") {
  CHECK(sets_of(names.each("2")) == std::vector<LabelSet>{{{0, {2}}}});
  CHECK(sets_of(names.each("7")) == std::vector<LabelSet>{{{0, {7}}}});
  CHECK(sets_of(names.each("liver,vein, portal,2,mask")) ==
        std::vector<LabelSet>{{{0, {1}}}, {{1, {1}}}, {{0, {2}}}, {{2, {}}}});
  CHECK(sets_of(names.each("region")) == std::vector<LabelSet>{{{0, {2, 3}}}});
  CHECK(sets_of(first_layer.each("720575940621039145,-3")) ==
        std::vector<LabelSet>{{{0, {720575940621039145}}}, {{0, {-3}}}});
}

TEST_CASE("label names match without regard to case and underscores if the match is unique") {
  CHECK(names.each("right lung")[0].name == "Right_Lung");
  CHECK(names.each("LIVER")[0].set == LabelSet{{0, {1}}});
}

TEST_CASE(
    "a single label keeps its name and colour, and several labels together have the given name") {
  const NamedLabels liver = names.together("liver");
  CHECK(liver.name == "liver");
  CHECK(liver.colour == discmc::command::Srgb{1, 2, 3});
  CHECK(first_layer.together("1").name == "liver");
  const NamedLabels several = names.together("liver,2,vein, portal,region");
  CHECK(several.name == "liver,2,vein, portal,region");
  CHECK(several.set == LabelSet{{0, {1, 2, 2, 3}}, {1, {1}}});
  const LabelNames masks({{"a", {}, {}, 0}, {"b", {}, {3}, 0}}, {0});
  CHECK(masks.together("b,a").set == LabelSet{{0, {}}});
  CHECK(masks.together("a,b").set == LabelSet{{0, {}}});
}

TEST_CASE("a value that several segments or none have is named by its number") {
  CHECK(names.named(0, 1).name == "liver");
  CHECK(names.named(0, 5).name == "5");
  CHECK(names.named(0, 2).name == "Right_Lung");
  CHECK(names.named(1, 2).name == "2");
  CHECK(names.named(2, 255).name == "mask");
}

TEST_CASE("unknown and ambiguous labels are refused") {
  check_refused(
      names, "1",
      "label 1 is 'liver' and, in another layer, 'vein, portal'; give a name, or the layer");
  check_refused(names, "44", "no label has the number 44: there are 'liver', ");
  check_refused(names, "twice",
                "several labels are called 'twice'; give their numbers, or the layer");
  check_refused(names, "liver,lver", "no label is called 'lver': there are 'liver', 'Right_Lung'");
  check_refused(names, "liver,", "no label is called ''");
  check_refused(LabelNames({}, {0}), "liver",
                "the labels have no names; give numbers, or --label-table");
  CHECK(first_layer.each("44")[0].set == LabelSet{{0, {44}}});
}
