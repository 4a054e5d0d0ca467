// PNG pictures, read back by libpng.
#include <png.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <limits>

#include "image/image.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;

namespace {

using Bytes = std::vector<unsigned char>;

Image row_of(const std::vector<float>& greys) {
    Image image;
    image.width = static_cast<int>(greys.size());
    image.height = 1;
    for (const float grey : greys) image.rgb.insert(image.rgb.end(), {grey, grey, grey});
    return image;
}

Bytes pixels_of(const Bytes& file, int& width, int& height) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&png, file.data(), file.size()));
    width = static_cast<int>(png.width);
    height = static_cast<int>(png.height);
    png.format = PNG_FORMAT_RGB;
    Bytes pixels(PNG_IMAGE_SIZE(png));
    REQUIRE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr));
    return pixels;
}

Bytes first_channel(const std::vector<float>& greys) {
    int width = 0, height = 0;
    const Bytes pixels = pixels_of(png_bytes(row_of(greys)), width, height);
    Bytes channel;
    for (std::size_t i = 0; i < pixels.size(); i += 3) channel.push_back(pixels[i]);
    return channel;
}

}  // namespace

TEST_CASE("a PNG has the sRGB curve of IEC 61966-2-1", "[png]") {
    // Half of the light is 188; the photographer's 18 % grey is 118; 0.0025 lies on the straight
    // piece.
    CHECK(first_channel({0, 1, 0.5f, 0.18f, 0.001f, 0.0025f, 0.2158605f}) ==
          Bytes{0, 255, 188, 118, 3, 8, 128});
}

TEST_CASE("what is out of range or no number still has a PNG value", "[png]") {
    const float inf = std::numeric_limits<float>::infinity();
    CHECK(first_channel({-1, 7, std::numeric_limits<float>::quiet_NaN(), inf, -inf}) ==
          Bytes{0, 255, 0, 255, 0});
}

TEST_CASE("rows of a PNG run from the top, channels are red, green, blue", "[png]") {
    Image image;
    image.width = 1;
    image.height = 2;
    image.rgb = {1, 0, 0, 0, 0, 1};
    int width = 0, height = 0;
    CHECK(pixels_of(png_bytes(image), width, height) == Bytes{255, 0, 0, 0, 0, 255});
    CHECK(width == 1);
    CHECK(height == 2);
}

TEST_CASE("a PNG says that it is sRGB", "[png]") {
    const Bytes bytes = png_bytes(row_of({0.5f}));
    const std::string chunk = "sRGB";
    CHECK(std::search(bytes.begin(), bytes.end(), chunk.begin(), chunk.end()) != bytes.end());
}

TEST_CASE("the PNG on disk is the PNG in memory", "[png]") {
    const ScratchFolder folder;
    const Image image = row_of({0, 0.3f, 0.9f});
    write_png(image, folder / "a.png");
    std::ifstream file(folder / "a.png", std::ios::binary);
    CHECK(Bytes(std::istreambuf_iterator<char>(file), {}) == png_bytes(image));
}
