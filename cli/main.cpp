// The program icespar: its command line, and which command runs.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <iostream>
#include <map>

#include "cli/commands.hpp"
#include "cli/stone.hpp"
#include "math/error.hpp"
#include "parser/diagnostic.hpp"

namespace {

using namespace icespar;

/// WIDTHxHEIGHT into the options; the message when it is not that.
std::string read_size(const std::string& text, RenderOptions& options) {
    int width = 0, height = 0, used = 0;
    const bool plain = text.find_first_not_of("0123456789xX") == std::string::npos &&
                       text.size() <= 13 &&
                       std::sscanf(text.c_str(), "%7d%*1[xX]%7d%n", &width, &height, &used) == 2 &&
                       used == static_cast<int>(text.size());
    if (!plain || width < 1 || height < 1 || width > 65536 || height > 65536)
        return "'" + text + "' is not WIDTHxHEIGHT with sides of 1 to 65536, such as 640x480";
    options.width = width;
    options.height = height;
    return {};
}

std::string positive(const std::string& text) {
    double value = 0;
    if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value) || value <= 0)
        return "'" + text + "' is not a positive number";
    return {};
}

/// A check that a whole number lies between two bounds.
auto whole(unsigned long long least, unsigned long long most) {
    return [=](const std::string& text) -> std::string {
        unsigned long long value = 0;
        const char* const end = text.data() + text.size();
        const auto [at, fault] = std::from_chars(text.data(), end, value);
        if (fault == std::errc() && at == end && value >= least && value <= most) return {};
        return "'" + text + "' is not a whole number from " + std::to_string(least) + " to " +
               std::to_string(most);
    };
}

std::string folder(const std::string& text) {
    std::error_code ignored;
    if (std::filesystem::is_directory(text, ignored)) return {};
    return "there is no folder '" + text + "'";
}

/// What CLI11 does with a wrong value, where there is a message.
void refuse(const std::string& message) {
    if (!message.empty()) throw CLI::ValidationError(message);
}

/// "render, check, ... and minerals"
std::string commands(const CLI::App& app) {
    std::vector<std::string_view> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    return listed(names, " and ");
}

const std::map<std::string, Engine> engines{{"auto", Engine::automatic},
                                            {"rays", Engine::rays},
                                            {"beams", Engine::beams},
                                            {"exact", Engine::exact}};

void add_engine(CLI::App* command, Engine& engine, const char* help) {
    const auto read = [&engine](const std::string& text) {
        const auto found = engines.find(text);
        if (found == engines.end()) {
            throw CLI::ValidationError(
                "--engine", "'" + text + "' is not an engine: rays, beams, exact or auto");
        }
        engine = found->second;
    };
    command->add_option_function<std::string>("--engine", read, help)
        ->type_name("rays|beams|exact|auto");
}

constexpr auto render_footer =
    "--error, --time and --spp may be given together: the bound that is reached first ends the\n"
    "render. Ctrl-C ends it too, and saves what is there; a second Ctrl-C saves nothing.\n"
    "The same scene, seed and samples give the same picture, bit for bit, for any --threads.\n"
    "Exit codes: 0 done, 1 the scene is at fault, 2 wrong usage, 3 interrupted but saved.\n"
    "Example: icespar render scenes/calcite_on_grid.spar -o grid.exr -o grid.png --error 0.02";

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "icespar: pictures of gemstones with the polarised light that birefringent crystals make"};
    app.require_subcommand(1);
    app.set_version_flag("--version", "icespar " ICESPAR_VERSION);
    app.footer(
        "`icespar COMMAND --help` says more about each. The scene language is POV-Ray's, with the\n"
        "words that crystals need: docs/language.md.");

    RenderArguments arguments;
    std::filesystem::path file;
    std::string mineral;

    CLI::App* render = app.add_subcommand("render", "Render a scene to .exr and .png files");
    render->footer(render_footer);
    render->add_option("SCENE", arguments.scene, "A scene in a .spar, .pov or .inc file")
        ->required();
    render
        ->add_option("-o,--output", arguments.outputs,
                     "The picture: .exr (linear, all that was asked) or .png (sRGB, to look at);\n"
                     "may be repeated")
        ->required()
        ->type_name("FILE")
        ->allow_extra_args(false);
    std::string size;
    render->add_option("--size", size, "Pixels across and down (default 640x480)")
        ->type_name("WxH")
        ->check([&](const std::string& text) { return read_size(text, arguments.options); });
    render->add_flag("--stokes", arguments.options.stokes,
                     "Keep the polarisation in the .exr: S1, S2, S3 beside S0");
    render
        ->add_option("--spectral", arguments.options.bands,
                     "Keep N spectral bands in the .exr, 1 to 400")
        ->type_name("N")
        ->check(whole(1, 400));
    add_engine(
        render, arguments.options.engine,
        "rays: samples; beams: whole pixels through stones; exact: whole facets of one stone\n"
        "in a parallel view (docs/method.md); auto: exact where it applies, else beams\n"
        "where there is a stone (default)");
    render
        ->add_option("--error", arguments.options.error,
                     "Stop when the picture's estimated relative error is below E; calm parts of "
                     "it stop earlier")
        ->type_name("E")
        ->check(positive);
    render
        ->add_option("--error-metric", arguments.options.metric,
                     "What --error bounds: the root mean square (rms, the default) of the pixels'\n"
                     "estimated errors, or the largest (max), over the picture's mean")
        ->type_name("rms|max")
        ->transform(CLI::CheckedTransformer(std::map<std::string, ErrorMetric>{
            {"rms", ErrorMetric::rms}, {"max", ErrorMetric::largest}}));
    render->add_option("--time", arguments.options.seconds, "Stop after T seconds")
        ->type_name("T")
        ->check(positive);
    render
        ->add_option("--spp", arguments.options.samples,
                     "Stop after N samples a pixel (default 64 when no other bound is given)")
        ->type_name("N")
        ->check(whole(1, 1 << 30));
    render->add_option("--threads", arguments.options.threads, "Threads (default: all there are)")
        ->type_name("N")
        ->check(whole(1, 4096));
    render->add_option("--seed", arguments.options.seed, "Another seed, another noise (default 0)")
        ->type_name("N")
        ->check(whole(0, ~0ULL));
    render
        ->add_option("--allow", arguments.allow,
                     "A folder the scene may read besides its own; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->check(folder);

    bool full = false;
    render->add_flag("--full", full,
                     "Use the full kernel where a lesser one would do: the same picture, later\n"
                     "(icespar plan says which)");

    Animation& animation = arguments.animation;
    bool two_clocks = false;
    render
        ->add_option_function<std::string>(
            "--frames", [&](const std::string& text) { refuse(read_frames(text, animation)); },
            "Render frames A to B, or those of an animation of N frames;\n"
            "frame 7 of name.png is name0007.png")
        ->type_name("A-B[/N]");
    const auto clock_option = [&](CLI::App* command, const char* type, const char* help) {
        const auto read = [&](const std::string& text) {
            refuse(read_clock(text, animation.clock_from, animation.clock_to, two_clocks));
        };
        command->add_option_function<std::string>("--clock", read, help)->type_name(type);
    };
    clock_option(render, "T|FROM,TO",
                 "What 'clock' is in the scene (default 0), or in the first and the last of\n"
                 "the frames (default 0,1)");
    render->add_flag("--resume", arguments.resume, "Leave alone what is there already");

    CLI::App* check = app.add_subcommand("check", "Read a scene and say what is wrong with it");
    check->footer("Exit codes: 0 nothing is wrong, 1 the scene is at fault, 2 wrong usage.");
    bool json = false;
    check->add_flag("--json", json, "The messages as a JSON array on stdout, for editors");
    clock_option(check, "T", "What 'clock' is in the scene (default 0)");
    check->add_option("SCENE", arguments.scene, "A scene in a .spar, .pov or .inc file")
        ->required();
    check
        ->add_option("--allow", arguments.allow,
                     "A folder the scene may read besides its own; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->check(folder);

    PlanArguments planned;
    CLI::App* plan = app.add_subcommand("plan", "Say how a scene would be rendered, and why");
    plan->footer(
        "What a scene does not need is not computed: one path serves all wavelengths where no "
        "stone\ndisperses, intensity does without Stokes vectors, and so on. `render` chooses in "
        "the "
        "same way.\nExit codes: 0 done, 1 the scene is at fault, 2 wrong usage.");
    plan->add_option("SCENE", planned.scene, "A scene in a .spar, .pov or .inc file")->required();
    plan->add_flag("--stokes", planned.stokes, "As if the polarisation were to be kept");
    add_engine(plan, planned.engine, "As if this engine were asked for");
    plan->add_flag("--full", planned.full, "As if the full kernel were asked for");
    clock_option(plan, "T", "What 'clock' is in the scene (default 0)");
    plan->add_option("--allow", arguments.allow,
                     "A folder the scene may read besides its own; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->check(folder);

    CLI::App* format =
        app.add_subcommand("format", "Print a scene evenly indented; its meaning is untouched");
    format->add_option("SCENE", arguments.scene, "A scene in a .spar, .pov or .inc file")
        ->required();
    bool in_place = false;
    format->add_flag("-i,--write", in_place, "Write it back into its file instead");

    CLI::App* stone =
        app.add_subcommand("stone", "Facets, volume and proportions of a faceting design");
    stone->add_option("FILE", file, "A design: .asc or .gem (GemCad), .gcs (Gem Cut Studio)")
        ->required();

    ConvertArguments conversion;
    CLI::App* convert = app.add_subcommand(
        "convert", "Write a faceting design in another format or for another index");
    convert->footer(
        "Formats, by ending: .asc and .gem (GemCad), .gcs (Gem Cut Studio); the stone as .stl, "
        ".obj.\n"
        "For another index the tangents of each side keep their ratios. The pavilion's lowest "
        "tier\n"
        "keeps what it exceeds the critical angle by; light from straight above keeps its "
        "direction\n"
        "behind the crown's largest tier; --pavilion and --crown set these angles instead.\n"
        "Example: icespar convert quartz.asc corundum.asc --index 1.76");
    convert->add_option("SOURCE", conversion.source, "The design to read")->required();
    convert->add_option("TARGET", conversion.target, "The file to write")->required();
    convert->add_option("--index", conversion.index, "Refractive index to cut it for")
        ->type_name("N")
        ->check(positive);
    convert->add_option("--from", conversion.from, "Index it was made for (default: the file's)")
        ->type_name("N")
        ->check(positive);
    convert
        ->add_option("--pavilion", conversion.pavilion, "New angle of the pavilion's lowest tier")
        ->type_name("DEG")
        ->check(positive);
    convert->add_option("--crown", conversion.crown, "New angle of the crown's largest tier")
        ->type_name("DEG")
        ->check(positive);

    CLI::App* minerals = app.add_subcommand("minerals", "What a stone may be made of");
    minerals->add_option("NAME", mineral,
                         "One mineral: its indices over the spectrum, its colours, the sources");
    bool colours = false;
    minerals->add_flag("--colours", colours,
                       "The colours of all minerals as CSV: white light behind 5 mm, by axis");

    // Their options are the Python package's, which answers --help too.
    app.add_subcommand("analyse", "Pictures and numbers of a design in a mineral, as a report");
    app.add_subcommand("compare", "Designs, or minerals, side by side");

    try {
        const auto named = [&](const CLI::App* command) { return command->check_name(argv[1]); };
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty()) {
            std::cerr << "icespar: there is no command '" << argv[1] << "'; the commands are "
                      << commands(app) << '\n';
            return exit_usage;
        }
        if (argc > 1 &&
            (argv[1] == std::string_view("analyse") || argv[1] == std::string_view("compare")))
            return python_command(argv + 1);
        app.parse(argc, argv);
        const auto still = [&](const std::string& command) {
            if (two_clocks) refuse("--clock: a " + command + " has one clock, not two");
            LoadOptions options;
            options.allow = arguments.allow;
            options.clock = animation.clock_from;
            return options;
        };
        if (render->parsed()) {
            RenderOptions& o = arguments.options;
            if (two_clocks && !animation.on)
                refuse("--clock: FROM,TO is for --frames; give one number for a still picture");
            if (!two_clocks && animation.on && render->count("--clock") > 0)
                refuse("--clock: with --frames it is FROM,TO");
            if (full) o.forced = Forced::everything();
            if (o.error == 0 && o.seconds == 0 && o.samples == 0) o.samples = 64;
            return render_command(arguments, std::cerr);
        }
        if (convert->parsed()) return convert_command(conversion, std::cerr);
        if (check->parsed()) {
            const LoadOptions options = still("check");
            return check_command(arguments.scene, options, json, std::cout, std::cerr);
        }
        if (plan->parsed()) return plan_command(planned, still("plan"), std::cout, std::cerr);
        if (format->parsed())
            return format_command(arguments.scene, in_place, std::cout, std::cerr);
        if (minerals->parsed()) return minerals_command(mineral, colours, std::cout, std::cerr);
        stone_command(file, std::cout);
        return exit_done;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_done : exit_usage;
    } catch (const std::bad_alloc&) {
        std::cerr << "icespar: there is not enough memory for this; ask for a smaller --size or "
                     "fewer bands\n";
    } catch (const std::exception& error) {
        std::cerr << "icespar: " << error.what() << '\n';
    }
    return exit_fault;
}
