// Files appear whole or not at all, and a refusal says what to do.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/image.hpp"
#include "math/error.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

Image noise(int side) {
    Image image;
    image.width = image.height = side;
    unsigned state = 1;
    for (int i = 0; i < 3 * side * side; ++i)
        image.rgb.push_back(static_cast<float>((state = state * 1664525 + 1013904223) >> 8));
    return image;
}

/// A disk with room for so many bytes a file.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace

TEST_CASE("a file appears under its name only when it is complete", "[file]") {
    const ScratchFolder folder;
    const std::string path = folder / "a.exr";
    put(path, "old");
    write_whole(path, [&](const std::string& partial) {
        CHECK(fs::path(partial).parent_path() == fs::path(path).parent_path());
        put(partial, "half");
        CHECK(content(path) == "old");
    });
    CHECK(content(path) == "half");
    CHECK(folder.files() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("a writer that fails leaves no file and does not touch an old one", "[file]") {
    const ScratchFolder folder;
    const std::string path = folder / "a.exr";
    const auto fails = [](const std::string& partial) {
        put(partial, "half");
        throw std::logic_error("the writer's own");
    };
    CHECK_THROWS_AS(write_whole(path, fails), std::logic_error);
    CHECK(folder.files().empty());
    put(path, "old");
    CHECK_THROWS_AS(write_whole(path, fails), std::logic_error);
    CHECK(folder.files() == std::vector<std::string>{"a.exr"});
    CHECK(content(path) == "old");
}

TEST_CASE("a disk that fills up costs the new picture, not the old one", "[file]") {
    const ScratchFolder folder;
    const std::string exr = folder / "a.exr", png = folder / "a.png";
    put(exr, "old");
    const Image image = noise(64);
    write_exr(image, folder / "whole.exr");
    write_png(image, folder / "whole.png");
    const auto all_of_exr = fs::file_size(folder / "whole.exr");
    const auto all_of_png = fs::file_size(folder / "whole.png");
    fs::remove(folder / "whole.exr");
    fs::remove(folder / "whole.png");

    const auto message = [&](std::size_t room, const auto& write) -> std::string {
        const SmallDisk disk(room);
        try {
            write();
        } catch (const Error& e) {
            return e.what();
        }
        return "(written)";
    };
    // Full at the header, amid the pixels, and at the table of rows, which OpenEXR writes last.
    for (const std::size_t room : {std::size_t{200}, std::size_t{9000}, all_of_exr - 1})
        CHECK_THAT(message(room, [&] { write_exr(image, exr); }),
                   Contains(exr) && Contains("free some space"));
    CHECK_THAT(message(all_of_png - 1, [&] { write_png(image, png); }),
               Contains(png) && Contains("free some space"));
    CHECK(content(exr) == "old");
    CHECK(folder.files() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("a pipe is written to, never replaced by a file", "[file]") {
    // In a folder of its own: were this to fail for a device, it would cost the machine that
    // device.
    const ScratchFolder folder;
    const std::string pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    REQUIRE(reader >= 0);
    const Image image = noise(4);
    write_png(image, pipe);
    std::vector<unsigned char> received(4096);
    const auto count = ::read(reader, received.data(), received.size());
    ::close(reader);
    REQUIRE(count > 0);
    received.resize(static_cast<std::size_t>(count));
    CHECK(received == png_bytes(image));
    CHECK(fs::is_fifo(pipe));
    CHECK(folder.files() == std::vector<std::string>{"pipe"});
}

TEST_CASE("a path that cannot be written is refused with the remedy", "[file]") {
    const ScratchFolder folder;
    const Image image = noise(2);
    CHECK_THROWS_WITH(write_png(image, folder / "no/such/a.png"),
                      Contains("there is no folder") && Contains("create it"));
    CHECK_THROWS_WITH(write_png(image, folder / ""), Contains("it is a folder"));
    CHECK_THROWS_WITH(write_png(image, ""), Contains("give a path"));
    CHECK_THROWS_AS(write_png(image, folder / std::string(300, 'a')), Error);
    CHECK(folder.files().empty());
}

TEST_CASE("a link stays a link, and an old file keeps its permissions", "[file]") {
    const ScratchFolder folder;
    put(folder / "real.png", "old");
    fs::permissions(folder / "real.png", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.png", folder / "link.png");
    write_png(noise(2), folder / "link.png");
    CHECK(fs::is_symlink(folder / "link.png"));
    CHECK(content(folder / "real.png") != "old");
    CHECK(fs::status(folder / "real.png").permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
}
