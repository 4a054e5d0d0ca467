// Faceting designs: what a cutter's file says, read from and written to the formats of the field.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stone/cut.hpp"

namespace icespar {

/// Facets cut at one angle and distance.
struct Tier {
    /// One facet: its place on the gear, and its name, which may be empty.
    struct Cut {
        double index = 0;
        std::string name{};
    };
    double angle = 0;     ///< degrees from the dop axis, as `cut_plane`; the sign of -0 counts
    double distance = 0;  ///< from the stone's centre
    std::vector<Cut> cuts;
    std::string instructions{};
};

struct Design {
    std::vector<Tier> tiers;
    double gear = 96, gear_offset = 0;  ///< a negative gear turns the other way
    int symmetry = 1;
    bool mirror = false;
    double refractive_index = 0;  ///< 0 where the file does not say
    std::vector<std::string> headers, footnotes;
    std::vector<std::string> remarks;  ///< what the file holds and the design cannot keep

    /// One plane a cut, in GemCad's right-handed frame, table up along z. Throws Error naming the
    /// facet whose numbers make no plane.
    [[nodiscard]] std::vector<FacetPlane> planes() const;
    [[nodiscard]] std::size_t facet_count() const;
};

/// The tier and index of a plane n . p = distance, n a unit vector: angle in degrees, negative on
/// the pavilion, and the index between 0 (not included) and the gear's teeth.
[[nodiscard]] double angle_of(const Vec3& normal);
[[nodiscard]] double index_of(const Vec3& normal, const Design& design);

/// Adds a facet to the last tier when that has the same plane but for the index and `number` is
/// that tier's, else to a new one. For formats that give planes.
class TierBuilder {
public:
    explicit TierBuilder(Design& design) : design_(design) {}
    void add(int number, const FacetPlane& plane, const std::string& instructions);
    /// An index without a name has that of the one before it in its tier; those before the first
    /// name have it.
    void finish();

private:
    Design& design_;
    int number_ = 0;
};

/// Gives unnamed cuts their tier's names, as `TierBuilder::finish`.
void spread_names(Tier& tier);

/// A design by its file's ending: .asc and .gem (GemCad), .gcs (Gem Cut Studio). Throws Error with
/// the file and the place in it.
[[nodiscard]] Design read_design(const std::filesystem::path& file);
[[nodiscard]] Design read_asc(std::string_view text, const std::string& name);
[[nodiscard]] Design read_gem(std::string_view bytes, const std::string& name);
[[nodiscard]] Design read_gcs(std::string_view text, const std::string& name);

/// Writes a design (.asc, .gem, .gcs) or its stone (.stl, .obj), whole or not at all. Returns what
/// the format cannot hold, as sentences. Throws Error when the ending is another, the file cannot
/// be written, or the stone does not close (not asked for .asc).
std::vector<std::string> write_design(const Design& design, const std::filesystem::path& file);
[[nodiscard]] std::string asc_text(const Design& design);
[[nodiscard]] std::string gem_bytes(const Design& design);
[[nodiscard]] std::string gcs_text(const Design& design);
[[nodiscard]] std::string stl_bytes(const Stone& stone);
[[nodiscard]] std::string obj_text(const Stone& stone, const std::string& title);

/// The design for another refractive index: crown and pavilion are stretched along the dop axis
/// about their edges of the girdle, so that all tangents of a side keep their ratios. An angle of 0
/// is found: the pavilion's lowest tier keeps what it exceeds the critical angle by, and light that
/// enters the crown's largest tier from straight above keeps its inner direction. Throws Error when
/// an index is not above 1 or no such angle exists.
struct Retarget {
    double from = 0, to = 0;         ///< refractive indices
    double pavilion = 0, crown = 0;  ///< degrees: new angles of those tiers, or 0
};
[[nodiscard]] Design retargeted(const Design& design, const Retarget& to);

}  // namespace icespar
