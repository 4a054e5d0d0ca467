// `icespar render SCENE -o FILE`: what it will do, the work, what it did.
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>
#include <thread>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/scene_file.hpp"
#include "math/error.hpp"

namespace icespar {

namespace {

namespace fs = std::filesystem;

std::string extension(const fs::path& file) {
    std::string text = file.extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Why the outputs cannot be written; empty when they can. Asked before any work is done.
std::string output_fault(const RenderArguments& arguments) {
    bool exr = false;
    for (const fs::path& file : arguments.outputs) {
        const std::string ending = extension(file);
        if (ending != ".exr" && ending != ".png")
            return "'" + file.string() + "': a picture is written as .exr or .png";
        exr = exr || ending == ".exr";
        std::error_code ignored;
        const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
        if (!fs::is_directory(folder, ignored))
            return "'" + file.string() + "': there is no folder '" + folder.string() +
                   "'; make it first";
        if (fs::is_directory(file, ignored))
            return "'" + file.string() + "' is a folder; name a file in it";
        if (access(folder.c_str(), W_OK | X_OK) != 0)
            return "'" + file.string() + "': the folder '" + folder.string() +
                   "' cannot be written to; choose another";
    }
    if (!exr && (arguments.options.stokes || arguments.options.bands > 0))
        return "--stokes and --spectral are kept in .exr files only; add -o FILE.exr";
    return {};
}

std::string format(const char* pattern, double value) {
    char text[48];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

std::string plan_line(const RenderArguments& arguments, Engine engine) {
    const RenderOptions& o = arguments.options;
    std::string bounds;
    const auto add = [&](const std::string& bound) {
        bounds += (bounds.empty() ? "until " : " or ") + bound;
    };
    if (o.error > 0) add(format("error %g", o.error));
    if (o.seconds > 0) add(format("%g s", o.seconds));
    if (engine == Engine::exact) {
        if (bounds.empty()) add(format("error %g", exact_error));
    } else if (o.samples > 0)
        add(std::to_string(o.samples) + (o.samples == 1 ? " sample a pixel" : " samples a pixel"));
    const unsigned threads =
        o.threads > 0 ? static_cast<unsigned>(o.threads) : std::thread::hardware_concurrency();
    std::string line = arguments.scene.string() + ": " + std::to_string(o.width) + "x" +
                       std::to_string(o.height) + " " + bounds + ", " + std::to_string(threads) +
                       (threads == 1 ? " thread" : " threads");
    if (o.bands > 0) line += ", " + std::to_string(o.bands) + " bands";
    if (o.stokes) line += ", Stokes";
    for (std::size_t i = 0; i < arguments.outputs.size(); ++i)
        line += (i == 0 ? " -> " : ", ") + arguments.outputs[i].string();
    return line;
}

std::string report_line(const RenderReport& report, const RenderOptions& options) {
    std::string line = report.interrupted ? "interrupted after " : "done in ";
    line += format("%.2f s, ", report.seconds);
    if (report.engine == Engine::exact) {
        line += std::to_string(report.events) + " exact beams";
    } else {
        const double rate = report.seconds > 0 ? 1e-6 * double(report.paths) / report.seconds : 0;
        line += format("%.3g Mpath/s, ", rate) + std::to_string(report.samples) +
                (report.samples == 1 ? " sample" : " samples") + " a pixel, by " +
                (report.engine == Engine::beams ? "beams" : "rays");
    }
    if (report.error > 0) line += format(", error %.2g", report.error);
    const double wanted = options.error > 0 ? options.error : exact_error;
    constexpr double much = 1.2;
    if (report.engine == Engine::exact && !report.interrupted && options.seconds == 0 &&
        report.error > much * wanted) {
        line += format(", more than the %g asked for", wanted) +
                " (ask for a smaller one, or for --engine beams)";
    }
    if (report.absorbed > 0) line += format(", absorbed energy %.2g", report.absorbed);
    return line + format(", dropped energy %.2g", report.dropped) + ", " +
           std::to_string(report.bad_samples) + " bad samples";
}

/// One picture from its scene to its files; `told` are the messages that the user has seen.
int render_picture(const RenderArguments& arguments, const LoadOptions& load,
                   std::set<std::string>& told, std::ostream& messages) {
    const ReadScene read = read_scene(arguments.scene, load, messages, &told);
    if (!read.scene) return exit_fault;
    const RenderOptions& o = arguments.options;
    const Needs needs = needs_of(*read.scene, o);
    messages << plan_line(arguments, needs.engine) << "\nby " << plan_summary(needs) << std::endl;
    Rendering rendering;
    {
        ProgressBar bar;
        rendering = render(*read.scene, arguments.options, [&](const Progress& progress) {
            bar.show(progress);
            return !InterruptGuard::requested();
        });
    }
    const bool interrupted = rendering.report.interrupted;
    if (interrupted && rendering.report.paths == 0) {
        messages << "interrupted before the first sample; nothing is written\n";
        return exit_interrupted_unsaved;
    }
    // A frame that is there counts as done when the render is resumed.
    if (interrupted && arguments.animation.on) {
        messages << "interrupted; this frame is not written: go on with --resume\n";
        return exit_interrupted_unsaved;
    }
    rendering.image.metadata["scene"] = arguments.scene.filename().string();
    if (arguments.animation.on) rendering.image.metadata["clock"] = format("%.17g", load.clock);
    for (const fs::path& file : arguments.outputs)
        extension(file) == ".exr" ? write_exr(rendering.image, file.string())
                                  : write_png(rendering.image, file.string());
    messages << report_line(rendering.report, arguments.options) << '\n';
    return interrupted ? exit_interrupted : exit_done;
}

bool all_there(const std::vector<fs::path>& files) {
    return std::all_of(files.begin(), files.end(), [](const fs::path& file) {
        std::error_code ignored;
        return fs::is_regular_file(file, ignored);
    });
}

}  // namespace

int render_command(const RenderArguments& arguments, std::ostream& messages) {
    if (const std::string fault = output_fault(arguments); !fault.empty()) {
        messages << "icespar: " << fault << '\n';
        return exit_usage;
    }
    LoadOptions load;
    load.width = arguments.options.width;
    load.height = arguments.options.height;
    load.allow = arguments.allow;
    load.clock = arguments.animation.clock_from;

    const InterruptGuard guard;
    std::set<std::string> told;
    bool saved = false;
    for (int frame = arguments.animation.first; frame <= arguments.animation.last; ++frame) {
        RenderArguments now = arguments;
        if (arguments.animation.on) {
            arguments.animation.tell(frame, load);
            for (fs::path& file : now.outputs) file = arguments.animation.file(file, frame);
        }
        if (arguments.resume && all_there(now.outputs)) {
            messages << now.outputs.front().string() << " is there already\n";
            saved = true;
            continue;
        }
        const int code = render_picture(now, load, told, messages);
        if (code == exit_interrupted_unsaved && saved) return exit_interrupted;
        if (code != exit_done) return code;
        saved = true;
    }
    return exit_done;
}

}  // namespace icespar
