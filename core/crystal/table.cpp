// Reading tables of comma-separated values.
#include "crystal/table.hpp"

#include <algorithm>
#include <charconv>

#include "math/error.hpp"

namespace icespar {

void Table::fail(int line, const std::string& what) const {
    throw Error("line " + std::to_string(line) + " of the table of " + name_ + ": " + what);
}

/// One row after RFC 4180: fields may be quoted, and then hold commas, line ends and doubled
/// quotes. Takes it from the front of `csv` and counts the lines gone by.
std::vector<std::string> Table::take_row(std::string_view& csv, int& line) const {
    std::vector<std::string> row(1);
    bool quoted = false;
    const int first_line = line;
    while (!csv.empty()) {
        const char c = csv.front();
        csv.remove_prefix(1);
        if (c == '\n') ++line;
        if (quoted) {
            if (c != '"') {
                row.back() += c;
            } else if (csv.starts_with('"')) {
                row.back() += c;
                csv.remove_prefix(1);
            } else {
                quoted = false;
            }
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            row.emplace_back();
        } else if (c == '\n') {
            return row;
        } else if (c != '\r') {
            row.back() += c;
        }
    }
    if (quoted) fail(first_line, "a quote is opened and not closed; add the closing one");
    return row;
}

std::vector<double> Table::numbers(std::string_view text, std::string_view separators,
                                   int line) const {
    std::vector<double> values;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
        if (text.empty()) return values;
        const std::string_view word = text.substr(0, text.find_first_of(separators));
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size())
            fail(line, "'" + std::string(word) + "' is not a number; write it as 1.2345");
        values.push_back(value);
        text.remove_prefix(word.size());
    }
}

Table::Table(std::string name, std::string_view csv, std::span<const char* const> wanted)
    : name_(std::move(name)) {
    int line = 1;
    const std::vector<std::string> heads = take_row(csv, line);
    for (std::size_t i = 0; i < heads.size(); ++i) columns_[heads[i]] = i;
    for (const char* head : wanted)
        if (!columns_.contains(head)) fail(1, std::string("there is no column '") + head + "'");
    while (!csv.empty()) {
        const int at = line;
        Row row{at, take_row(csv, line)};
        if (row.fields.size() == 1 && row.fields[0].empty()) continue;
        if (row.fields.size() != heads.size())
            fail(at, std::to_string(row.fields.size()) + " fields where the first line has " +
                         std::to_string(heads.size()) + "; quote a field that holds a comma");
        rows_.push_back(std::move(row));
    }
}

}  // namespace icespar
