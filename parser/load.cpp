// From a file or a text to a scene: parse, build, and look for faults in what was built.
#include "parser/load.hpp"

#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/encoding.hpp"
#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

/// The first line's comment says what the scene shows.
std::string title_of(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (!text.starts_with("//")) return {};
    text = text.substr(2, std::min(text.find_first_of("\r\n"), text.size()) - 2);
    while (!text.empty() && (text.front() == ' ' || text.front() == '/')) text.remove_prefix(1);
    return std::string(text);
}

LoadResult load(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                const LoadOptions& options) {
    Sources sources(folder, options.allow);
    Diagnostics diagnostics(sources);
    LoadResult result;
    std::string unreadable = not_a_text(text);
    if (text.size() > limits::file_bytes) {
        unreadable = "the scene is larger than " + std::to_string(limits::file_bytes >> 20) +
                     " MiB, the bound on a file";
    }
    if (!unreadable.empty()) {
        diagnostics.error(name, unreadable);
        result.diagnostics = diagnostics.take();
        return result;
    }
    const std::uint32_t file = sources.add(name, folder, std::string(text));
    try {
        warn_of_encoding(sources, diagnostics, file);
        Parser parser(sources, diagnostics, options);
        const BlockPtr tree = parser.parse(file);
        Builder builder(sources, diagnostics);
        Scene scene = builder.build(*tree);
        scene.title = title_of(text);
        if (diagnostics.errors() == 0) {
            for (const SceneFault& fault : scene_faults(scene)) {
                if (fault.gem) {
                    diagnostics.error(builder.gem_places()[*fault.gem], fault.message);
                } else {
                    diagnostics.error(name, fault.message);
                }
            }
            // A scene without a camera may be traced all the same.
            if (builder.camera_place()) {
                for (const std::string& fault : camera_faults(scene))
                    diagnostics.error(*builder.camera_place(), fault);
            }
        }
        if (diagnostics.errors() == 0) result.scene = std::move(scene);
    } catch (const Error& error) {
        Diagnostic d;
        d.file = name;
        d.message = error.what();
        result.diagnostics = diagnostics.take();
        result.diagnostics.push_back(std::move(d));
        return result;
    } catch (const Stop&) {
        // The message that stopped us is among the others.
    }
    result.diagnostics = diagnostics.take();
    return result;
}

}  // namespace

LoadResult load_scene_text(std::string_view text, const std::string& name,
                           const std::filesystem::path& folder, const LoadOptions& options) {
    return load(text, name, folder, options);
}

LoadResult load_scene_file(const std::filesystem::path& file, const LoadOptions& options) {
    std::error_code error;
    const auto text =
        std::filesystem::is_regular_file(file, error) ? Sources::read(file) : std::nullopt;
    if (!text) {
        LoadResult result;
        Diagnostic d;
        d.file = file.string();
        d.message = !std::filesystem::exists(file, error) ? "there is no such file"
                    : std::filesystem::is_directory(file, error)
                        ? "this is a folder: name a scene in it"
                        : "cannot be read as a scene, or is larger than 64 MiB";
        result.diagnostics.push_back(d);
        return result;
    }
    return load(*text, file.string(), file.parent_path(), options);
}

}  // namespace icespar
