// The progress bar's text, and when to draw it.
#include "cli/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace icespar {

namespace {

std::string clock_text(double seconds) {
    if (!(seconds >= 0) || seconds > 359999) return "--:--";
    const int whole = static_cast<int>(std::lround(seconds));
    char text[24];
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%02d:%02d", whole / 60, whole % 60);
    return text;
}

int terminal_columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string progress_line(const Progress& progress, int columns) {
    const double done = std::clamp(std::isfinite(progress.done) ? progress.done : 0, 0.0, 1.0);
    char percent[8], error[32] = "";
    std::snprintf(percent, sizeof percent, "%3d %% ", static_cast<int>(100 * done));
    if (progress.error > 0) std::snprintf(error, sizeof error, " error %.2g ", progress.error);
    const double left = done > 0 ? progress.seconds * (1 - done) / done : -1;
    const std::string times = " " + clock_text(progress.seconds) + "|" + clock_text(left);

    const std::string tail = error + times;
    const int width = std::clamp(columns - 1 - 6 - 2 - static_cast<int>(tail.size()), 0, 50);
    const int full = static_cast<int>(width * done);
    std::string line = percent;
    if (width > 0)
        line += "[" + std::string(static_cast<std::size_t>(full), '#') +
                std::string(static_cast<std::size_t>(width - full), '.') + "]";
    line += tail;
    return line.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0)));
}

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const Progress& progress) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;
    std::fprintf(stderr, "\r%s\033[K", progress_line(progress, terminal_columns()).c_str());
    std::fflush(stderr);
}

}  // namespace icespar
