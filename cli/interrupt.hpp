// Ctrl-C: the first asks the render to stop and save, the second ends the program at once.
#pragma once

namespace icespar {

/// While it lives, the first SIGINT or SIGTERM is noted instead of ending the program.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] static bool requested();
};

}  // namespace icespar
