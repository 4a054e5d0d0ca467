// Colours and spectra: rgb, spectrum { ... }, spectrum "file.csv" and gaussian { ... }.
#include <fast_float/fast_float.h>

#include <cmath>

#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

const Block* spectral_block(const Item& item) {
    const Block* block = item.kind == Item::Kind::block ? item.block.get()
                         : item.value.block()           ? item.value.block()->get()
                                                        : nullptr;
    return block && (block->word == "spectrum" || block->word == "gaussian") ? block : nullptr;
}

}  // namespace

bool Builder::next_is_ink(const Cursor& cursor) {
    if (!cursor.more() || cursor.peek().kind == Item::Kind::entry) return false;
    const Item& item = cursor.peek();
    return spectral_block(item) || (item.kind == Item::Kind::value && item.value.numbers());
}

Ink Builder::ink(Cursor& cursor, std::string_view what) {
    if (auto given = spectrum(cursor)) return {std::move(*given), {}};
    Ink out;
    out.rgb = cursor.colour(what);
    out.spectrum = reflectance_from_rgb({out.rgb[0], out.rgb[1], out.rgb[2]});
    return out;
}

std::optional<Spectrum> Builder::spectrum(Cursor& cursor, double least) {
    if (!cursor.more()) return std::nullopt;
    const Block* block = spectral_block(cursor.peek());
    if (!block) return std::nullopt;
    cursor.take();
    if (block->broken) throw Poisoned{block->place};
    return read_spectrum(*block, least);
}

Spectrum Builder::read_spectrum(const Block& block, double least) {
    Cursor cursor(block);
    try {
        if (block.word == "gaussian") {
            const double centre = cursor.number("a wavelength in nm", 1, 1e5);
            const double width = cursor.number("a full width at half height in nm", 1e-3, 1e5);
            const double height = cursor.number("a height", 0, 1e30);
            if (cursor.more()) {
                throw Fault{cursor.peek().place, "'gaussian' takes centre, width and height", {}};
            }
            std::vector<double> nodes, values;
            for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
                const double off = (nm - centre) / width;
                nodes.push_back(nm);
                values.push_back(height * std::exp2(-4 * off * off));
            }
            return {std::move(nodes), std::move(values)};
        }
        if (cursor.next_is(Item::Kind::value) && cursor.peek().value.text()) {
            const std::string file = cursor.text("the name of a file");
            return spectrum_file(file, cursor.place(), least);
        }
        std::vector<double> nodes, values;
        while (cursor.more()) {
            nodes.push_back(cursor.number("a wavelength in nm", 1, 1e5));
            values.push_back(cursor.number("the value at a wavelength", least, 1e30));
        }
        return {std::move(nodes), std::move(values)};
    } catch (const Error& error) {
        throw Fault{block.place, error.what(), "write spectrum { 400, 0.1, 500, 0.3 }"};
    }
}

/// Lines of a wavelength in nm and a value, parted by comma, semicolon or space; lines that do not
/// start with a number before the first that does are headings.
Spectrum Builder::spectrum_file(const std::string& file, const Place& place, double least) const {
    const auto text = Sources::read(file_named(file, place));
    if (!text) throw Fault{place, "'" + printable(file) + "' cannot be read", {}};
    std::vector<double> nodes, values;
    int line = 0;
    for (std::size_t at = 0; at < text->size(); ++line) {
        const std::size_t end = std::min(text->find('\n', at), text->size());
        const char *p = text->data() + at, *last = text->data() + end;
        at = end + 1;
        const auto skip = [&](std::string_view what) {
            while (p < last && what.find(*p) != std::string_view::npos) ++p;
        };
        skip(" \t\r\xef\xbb\xbf");
        if (p == last || *p == '#') continue;
        double nm = 0, value = 0;
        const auto first = fast_float::from_chars(p, last, nm);
        if (first.ec != std::errc() && nodes.empty()) continue;
        p = first.ptr;
        skip(" \t,;");
        const auto second = fast_float::from_chars(p, last, value);
        if (first.ec != std::errc() || second.ec != std::errc() || !(value >= least)) {
            throw Fault{place,
                        "line " + std::to_string(line + 1) + " of '" + printable(file) +
                            "' is not a wavelength in nm and a value",
                        {}};
        }
        nodes.push_back(nm);
        values.push_back(value);
    }
    try {
        return {std::move(nodes), std::move(values)};
    } catch (const Error& error) {
        throw Fault{place, "'" + printable(file) + "': " + error.what(), {}};
    }
}

}  // namespace icespar
