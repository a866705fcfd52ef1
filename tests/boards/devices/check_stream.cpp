// Checks that a stream matches its rows, except for the rows that it reports as skipped.
//
//   check_stream STREAM ROWS ROW_COUNT --dims X,Y,Z --threshold ...
//
// Prints: `same` or `different`, the number of skipped rows, and `whole` or `abandoned`.
#include <common/scan_arguments.hpp>
#include <discmc/decoder.hpp>
#include <fstream>
#include <gpio/row_source.hpp>
#include <iostream>
#include <set>
#include <sstream>

using namespace discmc;

namespace {

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

struct SkippedRows {
  std::uint32_t height;
  std::set<std::uint32_t> rows{};
  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::skipped) rows.insert(event.slice * height + event.row);
    return SinkResult::accepted;
  }
};

ByteOutput output_to(std::string& bytes) {
  return {&bytes, [](void* context, const std::uint8_t* begin, std::size_t count) {
            static_cast<std::string*>(context)->append(reinterpret_cast<const char*>(begin), count);
            return count;
          }};
}

struct Arguments {
  std::string stream;
  std::string rows;
  std::uint32_t row_count = 0;
  device::ScanArguments scan;
};

int run(const Arguments& arguments) {
  const device::ScanPlan& plan = arguments.scan.plan;
  const std::string stream = content(arguments.stream);
  SkippedRows skipped{plan.dims[1]};
  Decoder decoder;
  (void)decoder.start(make_sink(skipped));
  (void)decoder.push(reinterpret_cast<const std::uint8_t*>(stream.data()), stream.size());
  if (!decoder.report().is_complete()) throw std::runtime_error("the stream is incomplete");

  std::string expected;
  device::RowScan scan(plan, output_to(expected));
  const auto source = device::open_rows(arguments.rows);
  std::vector<std::uint8_t> row(plan.row_bytes());
  for (std::uint32_t i = 0; i < arguments.row_count; ++i) {
    source->read(i, row);
    if (skipped.rows.count(i) > 0)
      scan.skip(1);
    else
      scan.push(row.data());
  }
  decoder.report().is_abandoned ? scan.abandon() : scan.finish();
  std::cout << (stream == expected ? "same " : "different ") << skipped.rows.size()
            << (decoder.report().is_abandoned ? " abandoned\n" : " whole\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compares a stream with its rows", "check_stream"};
  Arguments arguments;
  app.add_option("STREAM", arguments.stream)->required();
  app.add_option("ROWS", arguments.rows)->required();
  app.add_option("ROW_COUNT", arguments.row_count)->required();
  device::add_scan_options(app, arguments.scan);
  return device::run_command(app, argc, argv, [&] { return run(arguments); });
}
