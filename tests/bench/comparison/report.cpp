#include "report.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

namespace discmc::bench {

namespace {

// With fewer cells, the figure would be the cost of a call, not of cells.
constexpr uint64_t many_cells = 50'000;

using Cells = std::vector<std::string>;  // of a row of the table

void print_row(const Cells& cells) {
  for (const std::string& cell : cells) std::printf("| %s ", cell.c_str());
  std::printf("|\n");
}

void print_head(const std::string& title, const Cells& cells) {
  std::printf("\n%s\n\n", title.c_str());
  print_row(cells);
  std::printf("|---|");
  for (size_t i = 1; i < cells.size(); ++i) std::printf("--:|");
  std::printf("\n");
}

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Grouped by thousands: 1,234,567.
std::string number(uint64_t value) {
  std::string digits = std::to_string(value);
  for (size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, ",");
  return digits;
}

Cells head(const std::vector<Result>& results, const Cells& first) {
  Cells cells = first;
  for (const Result& result : results) cells.push_back(result.contender);
  return cells;
}

void print_times(const std::vector<Measurement>& measurements) {
  print_head("Nanoseconds an active cell:",
             head(measurements.front().results, {"volume", "active cells"}));
  for (const Measurement& measurement : measurements) {
    Cells cells = {measurement.volume, number(measurement.active_cells)};
    for (const Result& result : measurement.results)
      cells.push_back(
          number(result.nanoseconds / static_cast<double>(measurement.active_cells), 0));
    print_row(cells);
  }
}

// Returns a contender's time divided by that of a contender of discmc.
struct Ratio {
  std::string name;
  size_t other, ours;

  double value(const Measurement& measurement) const {
    return measurement.results[other].nanoseconds / measurement.results[ours].nanoseconds;
  }
};

std::vector<Ratio> ratios(const std::vector<Result>& results) {
  std::vector<Ratio> ratios;
  for (const Place ours : {counting, polygons, stream})
    ratios.push_back({results[flying_edges_3d].contender + " / " + results[ours].contender,
                      flying_edges_3d, ours});
  for (size_t other = first_simplifier; other < results.size(); ++other)
    ratios.push_back(
        {results[other].contender + " / " + results[polygons].contender, other, polygons});
  return ratios;
}

// A row of the geometric means of some measurements, if there are any.
void print_means(const std::string& name, const std::vector<Measurement>& measurements,
                 const std::vector<Ratio>& ratios,
                 const std::function<bool(const Measurement&)>& is_counted) {
  std::vector<double> logarithms(ratios.size());
  size_t count = 0;
  for (const Measurement& measurement : measurements) {
    if (!is_counted(measurement)) continue;
    ++count;
    for (size_t i = 0; i < ratios.size(); ++i)
      logarithms[i] += std::log(ratios[i].value(measurement));
  }
  if (count == 0) return;
  Cells cells = {"*geometric mean of " + std::to_string(count) + ": " + name + "*"};
  for (const double sum : logarithms)
    cells.push_back("*" + number(std::exp(sum / static_cast<double>(count)), 2) + "*");
  print_row(cells);
}

void print_ratios(const std::vector<Measurement>& measurements) {
  const std::vector<Ratio> columns = ratios(measurements.front().results);
  Cells cells = {"volume"};
  for (const Ratio& ratio : columns) cells.push_back(ratio.name);
  print_head("How many times as long the others take:", cells);
  for (const Measurement& measurement : measurements) {
    cells = {measurement.volume};
    for (const Ratio& ratio : columns) cells.push_back(number(ratio.value(measurement), 2));
    print_row(cells);
  }
  const auto is_large = [](const Measurement& m) { return m.active_cells > many_cells; };
  const std::string large = ", above " + number(many_cells) + " cells";
  print_means("all", measurements, columns, [](const Measurement&) { return true; });
  print_means("all" + large, measurements, columns, is_large);
  print_means("given", measurements, columns, [](const Measurement& m) { return !m.is_generated; });
  print_means("given" + large, measurements, columns,
              [&](const Measurement& m) { return !m.is_generated && is_large(m); });
}

void print_made(const std::vector<Measurement>& measurements) {
  Cells cells = {"volume"};
  for (const Result& result : measurements.front().results)
    cells.push_back(result.contender + ": " + result.unit);
  print_head("What comes out:", cells);
  for (const Measurement& measurement : measurements) {
    cells = {measurement.volume};
    for (const Result& result : measurement.results) cells.push_back(number(result.made));
    print_row(cells);
  }
}

}  // namespace

void print_surfaces(const std::vector<Measurement>& measurements) {
  print_times(measurements);
  print_ratios(measurements);
  print_made(measurements);
}

void print_empty(const std::vector<Measurement>& measurements) {
  const std::vector<Result>& columns = measurements.front().results;
  constexpr size_t passes[] = {empty_plain_pass, empty_vector_pass};
  Cells cells = head(columns, {"volume"});
  for (const size_t pass : passes)
    cells.push_back(columns[empty_counting].contender + " / " + columns[pass].contender);
  print_head("Nanoseconds a voxel:", cells);
  for (const Measurement& measurement : measurements) {
    const std::vector<Result>& results = measurement.results;
    cells = {measurement.volume};
    for (const Result& result : results)
      cells.push_back(number(result.nanoseconds / static_cast<double>(measurement.voxels), 3));
    for (const size_t pass : passes)
      cells.push_back(number(results[empty_counting].nanoseconds / results[pass].nanoseconds, 2));
    print_row(cells);
  }
}

}  // namespace discmc::bench
