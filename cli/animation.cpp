// Reading --frames and --clock, and what follows from them for a frame.
#include "cli/animation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace icespar {
namespace {

/// The number that the text begins with is taken off it.
template <class Number>
bool take(std::string_view& text, Number& number) {
    const auto [at, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(at - text.data()));
    return true;
}

bool take(std::string_view& text, char mark) {
    if (!text.starts_with(mark)) return false;
    text.remove_prefix(1);
    return true;
}

}  // namespace

void Animation::tell(int frame, LoadOptions& options) const {
    options.frame_number = frame;
    options.initial_frame = from;
    options.final_frame = of;
    options.initial_clock = clock_from;
    options.final_clock = clock_to;
    const double part = of > from ? static_cast<double>(frame - from) / (of - from) : 0.0;
    options.clock = clock_from + (clock_to - clock_from) * part;
}

std::filesystem::path Animation::file(const std::filesystem::path& output, int frame) const {
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(of).size());
    std::string number = std::to_string(frame);
    number.insert(0, digits - number.size(), '0');
    return output.parent_path() / (output.stem().string() + number + output.extension().string());
}

std::string read_frames(const std::string& text, Animation& animation) {
    constexpr int most = 1'000'000;
    std::string_view rest = text;
    Animation a = animation;
    a.on = true;
    bool plain = take(rest, a.first) && take(rest, '-') && take(rest, a.last);
    a.from = a.first;
    a.of = a.last;
    if (plain && take(rest, '/')) {
        plain = take(rest, a.of);
        a.from = 1;
    }
    if (!plain || !rest.empty() || a.first < 0 || a.last < a.first || a.of < a.last ||
        a.of > most || a.first < a.from) {
        return "--frames: '" + text +
               "' is not A-B, two frames of 0 to 1000000, or A-B/N for a part of 1 to N";
    }
    animation = a;
    return {};
}

std::string read_clock(const std::string& text, double& from, double& to, bool& two) {
    std::string_view rest = text;
    bool plain = take(rest, from);
    two = plain && take(rest, ',');
    if (two) plain = take(rest, to);
    if (!plain || !rest.empty() || !std::isfinite(from) || (two && !std::isfinite(to)))
        return "--clock: '" + text + "' is not a number such as 0.5, nor two such as 0,1";
    return {};
}

}  // namespace icespar
