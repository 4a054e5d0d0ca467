// From the text of minerals.csv to its rows.
#include <algorithm>
#include <charconv>
#include <map>

#include "crystal/mineral.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

using Row = std::vector<std::string>;

[[noreturn]] void fail(int line, const std::string& what) {
    throw Error("line " + std::to_string(line) + " of the table of minerals: " + what);
}

/// One row after RFC 4180: fields may be quoted, and then hold commas, line ends and doubled
/// quotes. Takes it from the front of `csv` and counts the lines gone by.
Row take_row(std::string_view& csv, int& line) {
    Row row(1);
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

/// The numbers of a field, separated by any of `separators`.
std::vector<double> numbers(std::string_view text, std::string_view separators, int line) {
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

IndexFunction index_function(const std::string& model, std::vector<double> c, int line) {
    if (model == "formula 1") return IndexFunction::sellmeier1(std::move(c));
    if (model == "formula 2") return IndexFunction::sellmeier2(std::move(c));
    if (model == "formula 4") return IndexFunction::formula4(std::move(c));
    if (model == "cauchy_AB_um2" && c.size() == 2) return IndexFunction::cauchy(c[0], c[1]);
    fail(line,
         "no dispersion model '" + model + "' with " + std::to_string(c.size()) +
             " coefficients; there are formula 1, formula 2, formula 4 and cauchy_AB_um2 (2)");
}

}  // namespace

std::vector<Mineral> parse_minerals(std::string_view csv) {
    int line = 1;
    const Row heads = take_row(csv, line);
    std::map<std::string, std::size_t> columns;
    for (std::size_t i = 0; i < heads.size(); ++i) columns[heads[i]] = i;
    for (const char* head :
         {"id", "name", "formula", "crystal_system", "optic", "n1", "n2", "n3", "dispersion_BG",
          "dispersion_model", "coef1", "coef2", "coef3", "density", "confidence"})
        if (!columns.contains(head)) fail(1, std::string("there is no column '") + head + "'");

    std::vector<Mineral> found;
    while (!csv.empty()) {
        const int at = line;
        const Row row = take_row(csv, line);
        if (row == Row(1)) continue;
        if (row.size() != heads.size())
            fail(at, std::to_string(row.size()) + " fields where the first line has " +
                         std::to_string(heads.size()) + "; quote a field that holds a comma");
        const auto field = [&](const char* head) -> const std::string& {
            return row[columns.at(head)];
        };
        Mineral m;
        m.id = field("id");
        m.name = field("name");
        m.formula = field("formula");
        m.crystal_system = field("crystal_system");
        m.optic = field("optic");
        m.confidence = field("confidence");
        for (const char* head : {"n1", "n2", "n3"})
            for (const double n : numbers(field(head), " ", at)) m.indices_589.push_back(n);
        for (const char* head : {"coef1", "coef2", "coef3"})
            if (auto c = numbers(field(head), " ", at); !c.empty())
                m.indices.push_back(index_function(field("dispersion_model"), std::move(c), at));
        m.dispersion_bg = numbers(field("dispersion_BG"), "/ ", at);
        if (const auto density = numbers(field("density"), " ", at); !density.empty())
            m.density = density.front();

        const std::size_t wanted = m.optic == "isotropic"            ? 1
                                   : m.optic.starts_with("uniaxial") ? 2
                                   : m.optic.starts_with("biaxial")  ? 3
                                                                     : 0;
        if (wanted == 0)
            fail(at, "optic is '" + m.optic + "'; write isotropic, uniaxial or biaxial");
        if (m.indices.size() != wanted || m.indices_589.size() != wanted)
            fail(at, m.optic + " takes " + std::to_string(wanted) + " indices, not " +
                         std::to_string(m.indices.size()) + "; fill n1.. and coef1..");
        for (const auto& n : m.indices)
            if (!n.valid()) fail(at, "an index below 1 or not finite; check the coefficients");
        found.push_back(std::move(m));
    }
    return found;
}

}  // namespace icespar
