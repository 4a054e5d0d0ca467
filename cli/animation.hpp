// The frames of an animation: their numbers, their clock, their files.
#pragma once

#include <filesystem>
#include <string>

#include "parser/load.hpp"

namespace icespar {

/// A still picture is an animation that was not asked for.
struct Animation {
    bool on = false;
    int first = 1, last = 1;  ///< the frames to render
    int of = 1;               ///< the clock runs from frame `from` to this one
    int from = 1;
    double clock_from = 0, clock_to = 1;

    /// What the scene is told in this frame.
    void tell(int frame, LoadOptions& options) const;
    /// "name.png" becomes "name0007.png": four digits, more when the last frame needs them.
    [[nodiscard]] std::filesystem::path file(const std::filesystem::path& output, int frame) const;
};

/// "1-20", or "5-8/20" for a part of the frames 1 to 20. The message when it is neither.
[[nodiscard]] std::string read_frames(const std::string& text, Animation& animation);
/// "0.5" for a still picture, "0,1" for an animation. The message when it is neither.
[[nodiscard]] std::string read_clock(const std::string& text, double& from, double& to, bool& two);

}  // namespace icespar
