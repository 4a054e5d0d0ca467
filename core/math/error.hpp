// The one exception type of the library, and the assertion for our own mistakes.
#pragma once

#include <stdexcept>
#include <string>

namespace icespar {

/// A call that cannot be carried out. The message ends with the remedy.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace icespar
