#include "firmware_code.hpp"

#include <discmc/extractor.hpp>
#include <sstream>

namespace discmc::command {
namespace {

bool is_of_slices(const FirmwareChoice& choice) {
  return choice.arena_bytes == 0 && !choice.capacities;
}

bool is_open(const FirmwareChoice& choice) {
  return choice.limits.border == Border::open;
}

// INT32_MIN itself cannot be written as a literal.
std::string threshold_text(std::int32_t threshold) {
  return threshold == INT32_MIN ? "INT32_MIN" : std::to_string(threshold);
}

void write_cpp_memory(const FirmwareChoice& choice, std::ostream& out) {
  if (is_of_slices(choice)) {
    out << "constexpr discmc::SliceEncoderConfig config{limits, {threshold}, " << choice.key_slices
        << "};\n"
        << "static uint8_t memory[discmc::SliceEncoder::minimum_bytes(config)];\n"
        << "static discmc::SliceEncoder encoder;\n";
    return;
  }
  if (choice.capacities)
    out << "constexpr discmc::Capacities capacities{" << choice.capacities->slots << ", "
        << choice.capacities->holes << "};\n"
        << "static uint8_t memory[discmc::Extractor16::bytes_for(limits, capacities)];\n";
  else
    out << "static uint8_t memory[" << choice.arena_bytes << "];\n"
        << "static_assert(sizeof memory >= discmc::Extractor16::minimum_bytes(limits));\n";
  out << "static discmc::Extractor16 extractor;\n"
      << "static discmc::Encoder encoder;\n";
}

void write_c_memory(const FirmwareChoice& choice, std::ostream& out) {
  if (is_of_slices(choice)) {
    out << "enum { KEY_SLICE_INTERVAL = " << choice.key_slices << " };\n"
        << "static uint8_t memory[DISCMC_SLICE_ENCODER_BYTES(WIDTH, HEIGHT, 1)];\n";
    return;
  }
  const Capacities capacities =
      choice.capacities ? *choice.capacities
                        : Extractor16::default_capacities(choice.limits, choice.arena_bytes);
  out << "enum { SLOTS = " << capacities.slots << " };\n"
      << "static uint8_t extractor_memory[DISCMC_EXTRACTOR_BYTES(WIDTH, HEIGHT, SLOTS)];\n"
      << "static uint8_t encoder_memory[DISCMC_ENCODER_BYTES];\n";
}

}  // namespace

std::string cpp_code(const FirmwareChoice& choice) {
  const Limits& limits = choice.limits;
  std::ostringstream out;
  for (const std::string& comment : choice.comments) out << "// " << comment << '\n';
  out << "#include <discmc/discmc.hpp>\n\n"
      << "constexpr discmc::Limits limits{" << limits.width << ", " << limits.height
      << (is_open(choice) ? ", discmc::Border::open" : "") << "};\n"
      << "constexpr int32_t threshold = " << threshold_text(choice.threshold) << ";\n";
  write_cpp_memory(choice, out);
  return out.str();
}

std::string c_code(const FirmwareChoice& choice) {
  const Limits& limits = choice.limits;
  std::ostringstream out;
  for (const std::string& comment : choice.comments) out << "/* " << comment << " */\n";
  out << "#include <discmc/discmc.h>\n\n"
      << "enum { WIDTH = " << limits.width << ", HEIGHT = " << limits.height << " };\n"
      << "static const discmc_limits limits = {WIDTH, HEIGHT, "
      << (is_open(choice) ? "DISCMC_OPEN" : "DISCMC_CLOSED") << "};\n"
      << "static const int32_t threshold = " << threshold_text(choice.threshold) << ";\n";
  write_c_memory(choice, out);
  return out.str();
}

}  // namespace discmc::command
