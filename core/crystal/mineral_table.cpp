// From the text of minerals.csv to its rows.
#include <algorithm>

#include "crystal/mineral.hpp"
#include "crystal/table.hpp"

namespace icespar {
namespace {

IndexFunction index_function(const Table& table, const std::string& model, std::vector<double> c,
                             int line) {
    if (model == "formula 1") return IndexFunction::sellmeier1(std::move(c));
    if (model == "formula 2") return IndexFunction::sellmeier2(std::move(c));
    if (model == "formula 4") return IndexFunction::formula4(std::move(c));
    if (model == "cauchy_AB_um2" && c.size() == 2) return IndexFunction::cauchy(c[0], c[1]);
    table.fail(
        line, "no dispersion model '" + model + "' with " + std::to_string(c.size()) +
                  " coefficients; there are formula 1, formula 2, formula 4 and cauchy_AB_um2 (2)");
}

}  // namespace

std::vector<Mineral> parse_minerals(std::string_view csv) {
    constexpr const char* heads[] = {
        "id",    "name",  "formula", "crystal_system", "optic",
        "n1",    "n2",    "n3",      "dispersion_BG",  "dispersion_model",
        "coef1", "coef2", "coef3",   "density",        "confidence"};
    const Table table("minerals", csv, heads);
    std::vector<Mineral> found;
    for (const Table::Row& row : table.rows()) {
        const int at = row.line;
        const auto field = [&](const char* head) -> const std::string& {
            return table.field(row, head);
        };
        Mineral m;
        m.id = field("id");
        m.name = field("name");
        m.formula = field("formula");
        m.crystal_system = field("crystal_system");
        m.optic = field("optic");
        m.confidence = field("confidence");
        // Columns of words that a table need not have.
        const auto words = [&](const char* head) {
            return table.has(head) ? field(head) : std::string();
        };
        m.pleochroism = words("pleochroism");
        m.bands = words("absorption_bands_nm");
        m.rotation = words("optical_rotation_deg_mm");
        m.orientation = words("indicatrix_orientation");
        m.source = words("source_index");
        for (const char* head : {"n1", "n2", "n3"})
            for (const double n : table.numbers(field(head), " ", at)) m.indices_589.push_back(n);
        for (const char* head : {"coef1", "coef2", "coef3"})
            if (auto c = table.numbers(field(head), " ", at); !c.empty())
                m.indices.push_back(
                    index_function(table, field("dispersion_model"), std::move(c), at));
        m.dispersion_bg = table.numbers(field("dispersion_BG"), "/ ", at);
        if (const auto density = table.numbers(field("density"), " ", at); !density.empty())
            m.density = density.front();

        const std::size_t wanted = m.optic == "isotropic"            ? 1
                                   : m.optic.starts_with("uniaxial") ? 2
                                   : m.optic.starts_with("biaxial")  ? 3
                                                                     : 0;
        if (wanted == 0)
            table.fail(at, "optic is '" + m.optic + "'; write isotropic, uniaxial or biaxial");
        if (m.indices.size() != wanted || m.indices_589.size() != wanted)
            table.fail(at, m.optic + " takes " + std::to_string(wanted) + " indices, not " +
                               std::to_string(m.indices.size()) + "; fill n1.. and coef1..");
        for (const auto& n : m.indices)
            if (!n.valid())
                table.fail(at, "an index below 1 or not finite; check the coefficients");
        found.push_back(std::move(m));
    }
    return found;
}

}  // namespace icespar
