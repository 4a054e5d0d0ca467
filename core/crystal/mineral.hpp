// The minerals that ship with icespar: what a stone may be made of, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "crystal/index.hpp"
#include "crystal/medium.hpp"

namespace icespar {

/// One row of minerals.csv, whose sources and confidence are described beside it.
struct Mineral {
    std::string id, name, formula, crystal_system, optic;  ///< optic as in "uniaxial +"
    std::vector<IndexFunction>
        indices;  ///< one: isotropic; two: n_o, n_e; three: n_alpha < n_beta < n_gamma
    std::vector<double> indices_589;    ///< the published values at 589.3 nm, in the same order
    std::vector<double> dispersion_bg;  ///< published n(430.8 nm) - n(686.7 nm), in the same order
    double density = 0;                 ///< g/cm3
    std::string confidence;
    std::string pleochroism, bands, rotation, orientation, source;  ///< in words
};

/// All minerals, in the order of the table.
[[nodiscard]] std::span<const Mineral> minerals();

/// By id or name, whatever the case; blanks and hyphens count as the underscores of an id. Nothing
/// when there is none.
[[nodiscard]] const Mineral* find_mineral(std::string_view name);

/// Ids that somebody who wrote `name` may have meant, likeliest first, at most three: those a slip
/// or two away, and those whose name holds the word ("ruby": corundum). May be empty.
[[nodiscard]] std::vector<std::string> nearest_minerals(std::string_view name);

/// How a crystal lies. Uniaxial: the optic axis is `first`. Biaxial: n_alpha along `first`, n_beta
/// along `second`, n_gamma along their vector product.
struct CrystalAxes {
    Vec3 first{0, 0, 1}, second{1, 0, 0};
};

/// The medium of one to three indices (n | n_o, n_e | n_alpha, n_beta, n_gamma) at a wavelength in
/// vacuum. Throws Error for a wavelength that is not positive, where a formula has no positive
/// value, and for axes that Medium refuses.
[[nodiscard]] Medium medium_at(std::span<const IndexFunction> indices, double wavelength_nm,
                               const CrystalAxes& axes = {});

/// The transparent medium of a mineral; its optical activity is left out.
[[nodiscard]] inline Medium medium_at(const Mineral& mineral, double wavelength_nm,
                                      const CrystalAxes& axes = {}) {
    return medium_at(mineral.indices, wavelength_nm, axes);
}

/// A table with the columns of minerals.csv. Throws Error with the line.
[[nodiscard]] std::vector<Mineral> parse_minerals(std::string_view csv);

}  // namespace icespar
