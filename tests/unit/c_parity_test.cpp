// C can do all that C++ can: every public function of the headers has one in discmc.h, or a reason.
//
// A function `name` is discmc_name there, and `Class::name` discmc_class_name; of samples of any
// type it is three, which end in _u8, _u16 and _i16. What has another name, or none, is listed.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "project_text.hpp"

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

const fs::path library = fs::path(DISCMC_SOURCE_DIR) / "lib/discmc";

using discmc::test::text_of;

// ---- what the headers have ----

std::string without(const std::string& text, const char* pattern) {
  return std::regex_replace(text, std::regex(pattern), " ");
}

/// What a name of C++ may be in C: extractors and encoders are of several kinds.
const std::map<std::string, std::vector<std::string>> kinds = {
    {"Extractor", {"extractor", "normal_extractor", "learning_extractor"}},
    {"Encoder", {"encoder", "normal_encoder"}},
};

/// The public functions that a header declares, as `name` or `Class::name`.
class Declarations {
 public:
  explicit Declarations(const std::string& header) {
    std::string text = without(header, "//[^\n]*");
    text = without(text, "#[^\n]*(\\\\\n[^\n]*)*");
    for (const char character : text) take(character);
  }
  Names names;

 private:
  struct Scope {
    enum class Kind : uint8_t { names, type, other } kind;
    std::string name;
    bool is_public;
  };

  void take(char character) {
    if (character == '(') ++parentheses_;
    if (character == ')') --parentheses_;
    const bool ends = parentheses_ == 0 && (character == ';' || character == '{');
    if (ends) note();
    if (character == '{') begin_scope();
    if (character == '}' && !scopes_.empty()) scopes_.pop_back();
    if (ends || character == '}')
      words_.clear();
    else
      words_ += character;
    if (character == ':' && !scopes_.empty()) note_access();
  }

  void begin_scope() {
    static const std::regex type("\\b(class|struct)\\s+(\\w+)[^()=]*$");
    static const std::regex space("\\bnamespace(\\s+discmc)?\\s*$");
    std::smatch match;
    const std::string words = without(words_, parameters);
    if (std::regex_search(words, space))
      scopes_.push_back({Scope::Kind::names, "", true});
    else if (std::regex_search(words, match, type))
      scopes_.push_back({Scope::Kind::type, match[2], match[1] == "struct"});
    else
      scopes_.push_back({Scope::Kind::other, "", false});
  }

  void note_access() {
    static const std::regex access("\\b(public|private|protected)\\s*:$");
    std::smatch match;
    if (!std::regex_search(words_, match, access)) return;
    scopes_.back().is_public = match[1] == "public";
    words_.clear();
  }

  // Notes the function that the words declare, if it is one that everybody sees.
  void note() {
    static const std::regex function("(\\w+)\\s*\\(");
    if (!std::all_of(scopes_.begin(), scopes_.end(), [](const Scope& s) { return s.is_public; }))
      return;
    std::string words =
        without(without(words_, parameters), "\\[\\[.*?\\]\\]|\\b(using|friend)\\b[^;]*");
    if (words.find("operator") != std::string::npos || words.find("static_assert") < words.size())
      return;
    words = words.substr(0, std::min(words.find('='), words.find("(*")));
    std::smatch match;
    if (!std::regex_search(words, match, function)) return;
    std::string scope;
    for (const Scope& in : scopes_)
      if (in.kind == Scope::Kind::type) scope = in.name;
    if (match[1] == scope) return;  // a constructor
    names.insert(scope.empty() ? match[1].str() : scope + "::" + match[1].str());
  }

  static constexpr const char* parameters = "template\\s*<([^<>]|<[^<>]*>)*>";

  std::vector<Scope> scopes_;
  std::string words_;  // since the last declaration
  int parentheses_ = 0;
};

// ---- what C has ----

Names functions_of_c() {
  const std::string text =
      without(text_of(library / "discmc.h"), "/\\*[^*]*\\*+([^/*][^*]*\\*+)*/");
  Names names;
  const std::regex function("\\b(discmc_\\w+)\\(");
  for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at)
    names.insert((*at)[1]);
  return names;
}

std::string in_c(const std::string& name) {
  std::string result;
  for (const char character : name) {
    const bool is_upper = character >= 'A' && character <= 'Z';
    if (is_upper && !result.empty()) result += '_';
    result += is_upper ? static_cast<char>(character - 'A' + 'a') : character;
  }
  return result;
}

/// The names in C of a function in C++: one, or one of each kind.
std::vector<std::string> expected_of(const std::string& name) {
  const size_t colon = name.find("::");
  if (colon == std::string::npos) return {"discmc_" + name};
  const std::string type = name.substr(0, colon), function = name.substr(colon + 2);
  std::vector<std::string> expected;
  const auto found = kinds.find(type);
  for (const std::string& kind :
       found == kinds.end() ? std::vector<std::string>{in_c(type)} : found->second)
    expected.push_back("discmc_" + kind + "_" + function);
  return expected;
}

bool has(const Names& functions, const std::string& name) {
  return functions.count(name) > 0 ||
         (functions.count(name + "_u8") > 0 && functions.count(name + "_u16") > 0 &&
          functions.count(name + "_i16") > 0);
}

// ---- what differs ----

const Names internal_headers = {
    "arena.hpp",
    "pool.hpp",
    "compiler.hpp",
    "checkpoint.hpp",        // save and restore do it
    "gradient_normals.hpp",  // an extractor does it
    "c_extractors.hpp",
    "c_sink.hpp",
    "c_values.hpp",
};

/// By names in C++, or by the names that they would have in C where kinds differ: the names that
/// they have, or why they have none.
const std::map<std::string, std::string> others = {
    {"OctahedralNormal::is_none", "both bytes are zero"},
    {"PickedRange::count_of", "start works it out"},
    {"PlaneSide::meets_ray", "discmc_meets_ray"},
    {"Run::code", "a run is its code"},
    {"Run::from_code", "a run is its code"},
    {"Run::is_empty", "a run of 0 is"},
    {"SlabRange::end", "a sum of two members"},
    {"Slab::is_part", "one of two members"},
    {"StreamHeader::has_spacing", "members that are not zero"},
    {"StreamHeader::label", "members of the same name"},
    {"StreamHeader::surfaces", "a member and one"},
    {"StreamHeader::threshold_of", "members"},
    {"StreamReport::is_complete", "a member"},
    {"CheckpointStore::plan", "discmc_store_plan_for"},
    {"FlashGeometry::is_valid", "its plan has no slots"},
    {"FlashGeometry::units_per_block", "a quotient of two members"},
    {"StorePlan::blocks", "a member"},
    {"StorePlan::checkpoints_until_worn", "products of members"},
    {"StorePlan::is_valid", "slots are not 0"},
    {"StorePlan::microseconds", "products of members"},
    {"StorePlan::units", "a member"},
    {"Encoder::encode_normals", "discmc_normal_encoder_start"},
    {"KeySlices::is_every", "an interval of 1"},
    {"KeySlices::is_key", "a remainder"},
    {"add", "discmc_add_statistics"},
    {"axis_weights", "discmc_axis_weights_of"},
    {"cross", "arithmetic on members"},
    {"discmc_extractor_learn_in", "of another kind"},
    {"discmc_extractor_set_spacing", "of another kind"},
    {"discmc_learning_extractor_set_spacing", "of another kind"},
    {"discmc_normal_extractor_learn_in", "of another kind"},
    {"discmc_normal_extractor_push_bits", "bits have no gradient"},
    {"dot", "arithmetic on members"},
    {"face_of", "comparisons of members"},
    {"facet_of", "a shift"},
    {"group_of", "discmc_packed_bytes"},
    {"is_valid", "discmc_capacities_is_valid"},
    {"move", "discmc_after_run"},
    {"octahedral_normal", "discmc_octahedral_normal_along"},
    {"point_at", "points of cells are vertices"},
    {"position", "points of cells are vertices"},
    {"precedes", "comparisons of members"},
    {"record_of", "discmc_placement_record"},
    {"region_sink_to", "a sink of discmc_joiner_take"},
    {"row_sink_to", "a sink is a struct"},
    {"shape_of", "the lower three bits"},
    {"sink_to", "a sink is a struct"},
    {"slice_decoder_bytes", "discmc_slice_decoder_bytes_for"},
    {"store_plan", "discmc_store_plan_for"},
    {"status_of", "decoders and joiners say it"},
    {"unit_normal", "discmc_unit_normal_along"},
    {"worst_case_bytes", "discmc_bytes_for"},  // of discmc_worst_case_capacities()
};

}  // namespace

TEST_CASE("every public function of C++ has one in C, or a reason") {
  const Names of_c = functions_of_c();
  size_t count = 0;
  Names used;
  for (const fs::directory_entry& entry : fs::directory_iterator(library)) {
    const std::string header = entry.path().filename().string();
    if (entry.path().extension() != ".hpp" || internal_headers.count(header) > 0) continue;
    for (const std::string& name : Declarations(text_of(entry.path())).names)
      for (const std::string& expected : expected_of(name)) {
        ++count;
        if (has(of_c, expected)) continue;
        const std::string& listed = others.count(name) > 0 ? name : expected;
        const bool is_known = others.count(listed) > 0;
        CHECK_MESSAGE(is_known, header, ": no ", expected, "() in discmc.h, nor a reason here for ",
                      name, "()");
        used.insert(listed);
      }
  }
  CHECK(count > 200);
  for (const auto& other : others) {
    CAPTURE(other.first);
    CHECK(used.count(other.first) == 1);
    if (other.second.rfind("discmc_", 0) == 0) CHECK(has(of_c, other.second));
  }
}

TEST_CASE("public functions are found wherever they stand") {
  const Declarations found(R"(
    namespace discmc {
    /// words(), and a comment
    template <class A, class B = C<D>>
    class First : private Base<int> {
     public:
      First() = default;
      [[nodiscard]] Status one(const A& a, int b = 1) const { return inner(a); }
      template <class N = A> void two(int (&three)[3]);
      Answer (*member)(void* context) = nullptr;
     private:
      void hidden();
    };
    struct Second { constexpr bool four() const { return five(); } int six = seven(); };
    namespace trace { void eight(); }
    constexpr int nine(int x) { return ten(x); }
    }
    )");
  CHECK(found.names == Names{"First::one", "First::two", "Second::four", "nine"});
}
