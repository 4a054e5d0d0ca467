// Which format a design file has, and files as a whole.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "designs/design.hpp"
#include "image/image.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

constexpr std::uintmax_t largest_file = 16u << 20;

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// What is said of lines that a format has no room for.
void count_lines(const std::vector<std::string>& lines, std::size_t room, const char* what,
                 std::vector<std::string>& lost) {
    if (lines.size() > room)
        lost.push_back(std::to_string(lines.size() - room) + " " + what + " beyond the first " +
                       std::to_string(room) + " are left out");
}

}  // namespace

Design read_design(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::string ending = ending_of(file);
    const auto reader = ending == ".asc"   ? read_asc
                        : ending == ".gem" ? read_gem
                        : ending == ".gcs" ? read_gcs
                                           : nullptr;
    if (!reader) {
        throw Error(name +
                    ": designs end in .asc or .gem (GemCad) or .gcs (Gem Cut Studio): save it as "
                    "one of these");
    }
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) {
        throw Error(name + ": there is no such file: check the name and the folder");
    }
    if (std::filesystem::file_size(file, fault) > largest_file) {
        throw Error(name + ": the file is larger than 16 MiB, which no design is: check the name");
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    if (!stream) throw Error(name + ": the file cannot be read: check its permissions");
    return reader(text, name);
}

std::vector<std::string> write_design(const Design& design, const std::filesystem::path& file) {
    const std::string ending = ending_of(file);
    std::vector<std::string> lost;
    std::string bytes;
    if (ending == ".asc") {
        bytes = asc_text(design);
    } else if (ending == ".gem" || ending == ".gcs") {
        bytes = ending == ".gem" ? gem_bytes(design) : gcs_text(design);
        count_lines(design.headers, 4, "title lines", lost);
        count_lines(design.footnotes, 4, "footnotes", lost);
        if (ending == ".gem" && design.gear != static_cast<int>(design.gear))
            lost.push_back("the gear's fraction of a tooth is left out");
    } else if (ending == ".stl" || ending == ".obj") {
        const Stone stone = Stone::from_planes(design.planes());
        bytes = ending == ".stl"
                    ? stl_bytes(stone)
                    : obj_text(stone, design.headers.empty() ? "a stone" : design.headers.front());
    } else {
        throw Error(file.string() +
                    ": a design is written as .asc, .gem or .gcs, its stone as .stl or .obj: "
                    "choose one of these endings");
    }
    write_whole(file.string(), bytes);
    return lost;
}

}  // namespace icespar
