// Files that appear whole or not at all.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "image/checked_file.hpp"
#include "image/image.hpp"
#include "math/error.hpp"

namespace icespar {
namespace fs = std::filesystem;
namespace {

/// A new, empty file beside `target`, with the permissions a new file has.
std::string make_beside(const std::string& target, const std::string& shown) {
    for (int i = 0; i < 1000; ++i) {
        const std::string name =
            target + ".partial-" + std::to_string(::getpid()) + "-" + std::to_string(i);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return name;
        }
        if (errno != EEXIST) throw Error(cannot_write(shown, errno));
    }
    throw Error(
        cannot_write(shown, "old files '" + target + ".partial-*' are in the way; remove them"));
}

}  // namespace

void write_whole(const std::string& path, const std::function<void(const std::string&)>& write) {
    if (path.empty()) throw Error("cannot write to an empty file name; give a path");
    std::error_code ignored;
    // A link stays, what it points to is replaced.
    const fs::path resolved =
        fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : fs::path();
    const std::string target = resolved.empty() ? path : resolved.string();
    const fs::file_status status = fs::status(target, ignored);
    if (fs::is_directory(status))
        throw Error(cannot_write(path, "it is a folder; add a file name"));
    // Devices and pipes must not be replaced by a file.
    if (fs::exists(status) && !fs::is_regular_file(status)) return write(target);
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
        throw Error(
            cannot_write(path, "the file is write-protected; remove it or choose another name"));
    const fs::path folder = fs::path(target).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw Error(
            cannot_write(path, "there is no folder '" + folder.string() + "'; create it first"));

    const std::string partial = make_beside(target, path);
    try {
        write(partial);
        if (fs::exists(status)) fs::permissions(partial, status.permissions(), ignored);
        if (std::rename(partial.c_str(), target.c_str()) != 0)
            throw Error(cannot_write(path, errno));
    } catch (...) {
        fs::remove(partial, ignored);
        throw;
    }
}

void write_whole(const std::string& path, std::string_view bytes) {
    write_whole(path, [&](const std::string& partial) {
        CheckedFile file(partial, path);
        file.write(bytes.data(), bytes.size());
        file.close();
    });
}

}  // namespace icespar
