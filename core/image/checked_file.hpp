// A file being written whose every failure is noticed, even one met where nobody may throw.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace icespar {

/// "cannot write 'path': why", where `why` ends with the remedy.
[[nodiscard]] std::string cannot_write(const std::string& path, const std::string& why);
/// The same for an errno.
[[nodiscard]] std::string cannot_write(const std::string& path, int reason);

/// Writes to `path`; messages speak of `shown`, the name the user gave. All members throw Error
/// with the system's reason; after a failure every further call throws the same Error, so that
/// `close` at the end is proof that all went well.
class CheckedFile {
public:
    CheckedFile(const std::string& path, std::string shown);
    ~CheckedFile();
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;

    void write(const void* bytes, std::size_t count);
    void seek(std::uint64_t position);
    void close();

private:
    [[noreturn]] void fail();
    void check() const;

    std::FILE* file_ = nullptr;
    std::string shown_, failure_;
};

}  // namespace icespar
