#ifndef BENCHMARK_KNOWN_LENGTHS_H
#define BENCHMARK_KNOWN_LENGTHS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Known_lengths.h
/// Total lengths of other answers for the meshes of a folder, and how those found compare.

namespace corpus {

/// Columns of a table, added up, by mesh; and the total lengths over them.
class Known_lengths
{
public:
  /// \p source is FILE:COLUMN or FILE:COLUMN+COLUMN...: a table with tabs between the values, a
  /// line with the names of the columns, the first of which are the names of the meshes, lines with
  /// '#' as they like, and '-' where nothing is known.
  explicit Known_lengths(const std::string& source)
      : name_(source.substr(source.rfind(':') + 1)) {
    std::ifstream file(source.substr(0, source.rfind(':')));
    std::vector<std::size_t> columns;
    for(std::string line; std::getline(file, line);) {
      if(line.empty() || line[0] == '#')
        continue;
      const std::vector<std::string> values = split(line, '\t');
      if(columns.empty())
        columns = find_columns(values);
      else
        add(values, columns);
    }
    if(lengths_.empty())
      throw std::runtime_error(source + ": no lengths");
  }

  void compare(const std::string& mesh, double length) {
    const auto it = lengths_.find(mesh);
    if(it != lengths_.end())
      ratios_.emplace_back(length / it->second, mesh);
  }

  void print() const {
    if(ratios_.empty())
      return;
    double sum = 0.;
    for(const auto& r : ratios_)
      sum += std::log(r.first);
    std::printf(
        "\ntotal length over %s, %zu meshes: geometric mean %.4f, above 1.0005 on %zu, above "
        "1.02 on %zu; the largest:",
        name_.c_str(), ratios_.size(), std::exp(sum / double(ratios_.size())), above(1.0005),
        above(1.02));
    std::vector<std::pair<double, std::string>> sorted = ratios_;
    std::sort(sorted.rbegin(), sorted.rend());
    for(std::size_t i = 0; i < sorted.size() && i < 6; ++i)
      std::printf(" %s %.4f", sorted[i].second.c_str(), sorted[i].first);
    std::printf("\n");
  }

private:
  static std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for(std::string part; std::getline(stream, part, separator);)
      parts.push_back(part);
    return parts;
  }

  std::vector<std::size_t> find_columns(const std::vector<std::string>& names) const {
    std::vector<std::size_t> columns;
    for(const std::string& name : split(name_, '+')) {
      const auto it = std::find(names.begin(), names.end(), name);
      if(it == names.end())
        throw std::runtime_error("there is no column " + name);
      columns.push_back(it - names.begin());
    }
    return columns;
  }

  void add(const std::vector<std::string>& values, const std::vector<std::size_t>& columns) {
    double sum = 0.;
    for(std::size_t c : columns) {
      if(c >= values.size() || values[c] == "-")
        return;
      sum += std::strtod(values[c].c_str(), nullptr);
    }
    lengths_[values[0]] = sum;
  }

  std::size_t above(double limit) const {
    return static_cast<std::size_t>(std::count_if(
        ratios_.begin(), ratios_.end(), [limit](const auto& r) { return r.first > limit; }));
  }

  std::string name_;
  std::map<std::string, double> lengths_;
  std::vector<std::pair<double, std::string>> ratios_;
};

} // namespace corpus

#endif // BENCHMARK_KNOWN_LENGTHS_H
