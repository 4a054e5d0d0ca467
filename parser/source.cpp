// Reading source files within bounds, and turning byte offsets into lines and columns.
#include "parser/source.hpp"

#include <algorithm>
#include <fstream>

#include "designs/text.hpp"
#include "parser/encoding.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace fs = std::filesystem;

Place joined(const Place& a, const Place& b) {
    if (a.file != b.file || b.end < a.begin) return a;
    return {a.file, a.begin, b.end, a.route};
}

Sources::Sources(const fs::path& scene_folder, const std::vector<fs::path>& allow) {
    const auto add_root = [this](const fs::path& folder) {
        std::error_code error;
        fs::path real = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
        if (!error) roots_.push_back(std::move(real));
    };
    add_root(scene_folder);
    for (const fs::path& folder : allow) add_root(folder);
}

std::uint32_t Sources::add(std::string name, fs::path folder, std::string text) {
    SourceFile file{std::move(name), std::move(folder), std::move(text), {0}};
    if (!is_utf8(file.text)) {
        file.was_utf8 = false;
        file.text = utf8(file.text);
    }
    unify_line_ends(file.text);
    for (std::size_t i = 0; i < file.text.size(); ++i) {
        if (file.text[i] == '\n') file.line_starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    files_.push_back(std::move(file));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

std::uint32_t Sources::add_route(const RouteStep& step) {
    routes_.push_back(step);
    return static_cast<std::uint32_t>(routes_.size() - 1);
}

LineColumn Sources::line_column(std::uint32_t file, std::uint32_t offset) const {
    const SourceFile& f = files_[file];
    const auto next = std::upper_bound(f.line_starts.begin(), f.line_starts.end(), offset);
    const std::uint32_t start = *(next - 1);
    int column = 1;
    for (std::uint32_t i = start; i < offset && i < f.text.size(); ++i) {
        const bool continues = (static_cast<unsigned char>(f.text[i]) & 0xc0) == 0x80;
        if (!continues) ++column;
    }
    return {static_cast<int>(next - f.line_starts.begin()), column};
}

std::string_view Sources::line(std::uint32_t file, int line) const {
    const SourceFile& f = files_[file];
    const std::size_t start = f.line_starts[static_cast<std::size_t>(line - 1)];
    std::string_view rest = std::string_view(f.text).substr(start);
    rest = rest.substr(0, rest.find('\n'));
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    return rest;
}

std::string Sources::file_and_line(const Place& place) const {
    return files_[place.file].name + ":" +
           std::to_string(line_column(place.file, place.begin).line);
}

bool Sources::inside(const fs::path& real_path) const {
    return std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
        return std::mismatch(root.begin(), root.end(), real_path.begin(), real_path.end()).first ==
               root.end();
    });
}

Sources::Found Sources::find(std::string_view name, const fs::path& beside) const {
    Found found;
    if (name.empty() || name.find('\0') != std::string_view::npos) return found;
    std::vector<fs::path> candidates;
    const fs::path wanted(name);
    if (wanted.is_absolute()) {
        candidates.push_back(wanted);
    } else {
        candidates.push_back((beside.empty() ? fs::path(".") : beside) / wanted);
        for (const fs::path& root : roots_) candidates.push_back(root / wanted);
    }
    for (const fs::path& candidate : candidates) {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(candidate, error);
        if (error) continue;
        // Out of bounds is said without looking: whether the file exists is not the scene's
        // business.
        if (!inside(real)) {
            found.forbidden = true;
            continue;
        }
        if (fs::is_regular_file(real, error) && !error) return {real, false};
    }
    return found;
}

std::optional<std::string> Sources::read(const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path, error);
    if (error || size > limits::file_bytes) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!in.read(text.data(), static_cast<std::streamsize>(size)) && size > 0) return std::nullopt;
    return text;
}

}  // namespace icespar
