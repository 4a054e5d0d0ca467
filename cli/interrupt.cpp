// Ctrl-C: a signal handler that does nothing but note the signal.
#include "cli/interrupt.hpp"

#include <csignal>

namespace icespar {

namespace {
volatile std::sig_atomic_t noted = 0;

void note(int) { noted = 1; }
}  // namespace

InterruptGuard::InterruptGuard() {
    noted = 0;
    struct sigaction action {};
    action.sa_handler = note;
    // After the first signal the default action is back, so that the second one ends the program.
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::requested() { return noted != 0; }

}  // namespace icespar
