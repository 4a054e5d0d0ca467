// A table of comma-separated values (RFC 4180) whose columns have names.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace icespar {

class Table {
public:
    /// Throws Error that names the table and the line when a row has more or fewer fields than the
    /// first line has names, or one of `wanted` is missing there.
    Table(std::string name, std::string_view csv, std::span<const char* const> wanted);

    struct Row {
        int line;
        std::vector<std::string> fields;
    };
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] const std::string& field(const Row& row, const char* head) const {
        return row.fields[columns_.at(head)];
    }
    [[nodiscard]] bool has(const char* head) const { return columns_.contains(head); }
    /// The numbers of a text, separated by any of `separators`.
    [[nodiscard]] std::vector<double> numbers(std::string_view text, std::string_view separators,
                                              int line) const;
    [[noreturn]] void fail(int line, const std::string& what) const;

private:
    std::vector<std::string> take_row(std::string_view& csv, int& line) const;

    std::string name_;
    std::map<std::string, std::size_t> columns_;
    std::vector<Row> rows_;
};

}  // namespace icespar
