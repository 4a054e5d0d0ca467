// Writing through the C library, with every failure kept and explained.
#include "image/checked_file.hpp"

#include <sys/types.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "math/error.hpp"

namespace icespar {

std::string cannot_write(const std::string& path, const std::string& why) {
    return "cannot write '" + path + "': " + why;
}

std::string cannot_write(const std::string& path, int reason) {
    std::string why = std::strerror(reason);
    switch (reason) {
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return cannot_write(path, why + "; free some space or choose another folder");
        case EACCES:
        case EPERM:
        case EROFS:
            return cannot_write(path, why + "; choose a folder you may write to");
        default:
            return cannot_write(path, why + "; check the path or choose another one");
    }
}

CheckedFile::CheckedFile(const std::string& path, std::string shown)
    : file_(std::fopen(path.c_str(), "wb")), shown_(std::move(shown)) {
    if (!file_) fail();
}

CheckedFile::~CheckedFile() {
    if (file_) std::fclose(file_);
}

void CheckedFile::fail() {
    failure_ = cannot_write(shown_, errno);
    throw Error(failure_);
}

void CheckedFile::check() const {
    if (!failure_.empty()) throw Error(failure_);
}

void CheckedFile::write(const void* bytes, std::size_t count) {
    check();
    if (std::fwrite(bytes, 1, count, file_) != count) fail();
}

void CheckedFile::seek(std::uint64_t position) {
    check();
    if (::fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail();
}

void CheckedFile::close() {
    check();
    if (std::fclose(std::exchange(file_, nullptr)) != 0) fail();
}

}  // namespace icespar
