// Whether a view's caller still wants it.
#pragma once

#include <chrono>

#include "views/view.hpp"

namespace icespar {

class Watch {
public:
    explicit Watch(const ViewOptions& options) : options_(options) {}

    static constexpr unsigned beams_between_looks = 4096;

    void look() { stopped_ = stopped_ || (options_.go_on && !options_.go_on()); }
    [[nodiscard]] bool stopped() const { return stopped_; }
    [[nodiscard]] bool out_of_time() const {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        return options_.seconds != 0 && !(spent.count() < options_.seconds);
    }

private:
    const ViewOptions& options_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    bool stopped_ = false;  ///< by go_on
};

}  // namespace icespar
