// The bar that a render draws while it works, and nothing at all unless stderr is a terminal.
#pragma once

#include <chrono>
#include <string>

#include "render/render.hpp"

namespace icespar {

/// One line of text, at most `columns` wide: part done, a bar, the error so far, elapsed|left.
[[nodiscard]] std::string progress_line(const Progress& progress, int columns);

class ProgressBar {
public:
    ProgressBar();
    ~ProgressBar();  ///< wipes the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Draws at most ten times a second.
    void show(const Progress& progress);

private:
    bool terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace icespar
