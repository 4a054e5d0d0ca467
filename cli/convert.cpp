// Reads a design, retargets it where asked, and writes it in another format.
#include <cmath>
#include <iostream>

#include "cli/commands.hpp"
#include "designs/design.hpp"
#include "math/error.hpp"

namespace icespar {

int convert_command(const ConvertArguments& arguments, std::ostream& messages) {
    const bool retargets = arguments.index > 0 || arguments.pavilion != 0 || arguments.crown != 0;
    if (arguments.from > 0 && !retargets)
        throw Error("--from: nothing is changed from it; give --index, --pavilion or --crown too");
    Design design = read_design(arguments.source);
    for (const std::string& remark : design.remarks)
        messages << arguments.source.string() << ": warning: " << remark << '\n';
    if (retargets) {
        if (!(design.refractive_index > 0) && !(arguments.from > 0))
            throw Error(arguments.source.string() +
                        ": the design does not say for which index it is: give --from");
        const double from = arguments.from > 0 ? arguments.from : design.refractive_index;
        design = retargeted(design, {from, arguments.index > 0 ? arguments.index : from,
                                     arguments.pavilion, arguments.crown});
    }
    for (const std::string& lost : write_design(design, arguments.target))
        messages << arguments.target.string() << ": warning: " << lost << '\n';
    messages << arguments.target.string() << ": " << design.facet_count() << " facets in "
             << design.tiers.size() << " tiers\n";
    return exit_done;
}

}  // namespace icespar
