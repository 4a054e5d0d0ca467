// Writes GemCad's text format (.asc), every number so that it reads back as it was.
#include <cmath>

#include "designs/design.hpp"
#include "designs/text.hpp"

namespace icespar {

std::string asc_text(const Design& design) {
    const auto line = [](std::string_view text) {
        std::string out = for_gemcad(text);
        for (char& c : out) {
            if (static_cast<unsigned char>(c) < ' ') c = ' ';
        }
        return out + "\r\n";
    };
    std::string out = "GemCad 5.0\r\n";
    out += "g " + exact(design.gear) + " " + exact(design.gear_offset) + "\r\n";
    out += "y " + std::to_string(design.symmetry) + (design.mirror ? " y\r\n" : " n\r\n");
    out += "I " + exact(design.refractive_index) + "\r\n";
    for (const std::string& header : design.headers) out += "H " + line(header);
    for (const Tier& tier : design.tiers) {
        out += "a " + exact(tier.angle) + " " + exact(tier.distance);
        std::string name;
        for (const Tier::Cut& cut : tier.cuts) {
            out += " " + exact(cut.index);
            if (cut.name != name) out += " n " + for_gemcad(one_word(cut.name));
            name = cut.name;
        }
        if (!tier.instructions.empty()) {
            out += " G " + line(tier.instructions);
        } else {
            out += "\r\n";
        }
    }
    for (const std::string& footnote : design.footnotes) out += "F " + line(footnote);
    return out;
}

}  // namespace icespar
