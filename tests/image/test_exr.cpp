// What stands in an OpenEXR file, read back by OpenEXR itself.
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "image/image.hpp"
#include "math/error.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Contains;

namespace {

/// Each number of a picture says where it belongs.
Image numbered(int bands, int components) {
    Image image;
    image.width = 5;
    image.height = 3;
    for (int i = 0; i < 5 * 3 * 3; ++i) image.rgb.push_back(0.25f * static_cast<float>(i));
    for (int b = 0; b < bands; ++b) image.wavelengths_nm.push_back(440 + 12.5 * b);
    image.spectral_components = bands > 0 ? components : 0;
    for (int i = 0; i < 5 * 3 * bands * components; ++i)
        image.spectral.push_back(static_cast<float>(1000 + i));
    if (bands == 0 && components == 4)
        for (int i = 0; i < 5 * 3 * 9; ++i) image.rgb_stokes.push_back(-static_cast<float>(i));
    return image;
}

class ReadBack {
public:
    explicit ReadBack(const std::string& path) : file_(path.c_str()) {}

    std::vector<std::string> channels() const {
        std::vector<std::string> names;
        for (auto c = file_.header().channels().begin(); c != file_.header().channels().end(); ++c)
            names.emplace_back(c.name());
        return names;
    }
    std::vector<float> channel(const std::string& name) {
        REQUIRE(file_.header().channels().findChannel(name));
        CHECK(file_.header().channels().findChannel(name)->type == Imf::FLOAT);
        const auto box = file_.header().dataWindow();
        const int width = box.max.x - box.min.x + 1, height = box.max.y - box.min.y + 1;
        std::vector<float> values(static_cast<std::size_t>(width * height));
        Imf::FrameBuffer places;
        places.insert(name,
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                 sizeof(float) * static_cast<std::size_t>(width)));
        file_.setFrameBuffer(places);
        file_.readPixels(box.min.y, box.max.y);
        return values;
    }
    std::string text(const std::string& name) const {
        const auto* a = file_.header().findTypedAttribute<Imf::StringAttribute>(name);
        return a ? a->value() : "(none)";
    }

private:
    Imf::InputFile file_;
};

}  // namespace

TEST_CASE("a plain picture is three channels, row by row from the top", "[exr]") {
    const ScratchFolder folder;
    Image image = numbered(0, 1);
    image.metadata = {{"seed", "7"}, {"version", "0.1"}, {"scene", "caf\xc3\xa9.spar"}};
    write_exr(image, folder / "a.exr");
    ReadBack back(folder / "a.exr");
    CHECK(back.channels() == std::vector<std::string>{"B", "G", "R"});
    const auto red = back.channel("R"), blue = back.channel("B");
    for (std::size_t pixel = 0; pixel < 15; ++pixel) {
        CHECK(red[pixel] == image.rgb[3 * pixel]);
        CHECK(blue[pixel] == image.rgb[3 * pixel + 2]);
    }
    CHECK(back.text("icespar:seed") == "7");
    CHECK(back.text("icespar:version") == "0.1");
    CHECK(back.text("icespar:scene") == "caf\xc3\xa9.spar");
    CHECK(back.text("spectralLayoutVersion") == "(none)");
    CHECK(back.text("polarisationHandedness") == "(none)");
}

TEST_CASE("spectral bands have the published names, order and attributes", "[exr]") {
    const ScratchFolder folder;
    const int components = GENERATE(1, 4);
    const Image image = numbered(3, components);
    write_exr(image, folder / "a.exr");
    ReadBack back(folder / "a.exr");
    CHECK(back.channels().size() == static_cast<std::size_t>(3 + 3 * components));
    const std::vector<std::string> names{"440,000000nm", "452,500000nm", "465,000000nm"};
    const auto n = static_cast<std::size_t>(components);
    for (std::size_t band = 0; band < 3; ++band)
        for (std::size_t s = 0; s < n; ++s) {
            const auto values = back.channel("S" + std::to_string(s) + "." + names[band]);
            for (std::size_t pixel = 0; pixel < 15; ++pixel)
                CHECK(values[pixel] == image.spectral[(pixel * 3 + band) * n + s]);
        }
    CHECK(back.text("spectralLayoutVersion") == "1.0");
    CHECK(back.text("emissiveUnits") == "W.m^-2.sr^-1");
    CHECK(back.text("polarisationHandedness") == (components == 4 ? "right" : "(none)"));
}

TEST_CASE("polarisation without bands has Mitsuba's channel names", "[exr]") {
    const ScratchFolder folder;
    const Image image = numbered(0, 4);
    write_exr(image, folder / "a.exr");
    ReadBack back(folder / "a.exr");
    CHECK(back.channels().size() == 15);
    const auto intensity = back.channel("S0.G"), s1_red = back.channel("S1.R"),
               s3_blue = back.channel("S3.B");
    for (std::size_t pixel = 0; pixel < 15; ++pixel) {
        CHECK(intensity[pixel] == image.rgb[3 * pixel + 1]);
        CHECK(s1_red[pixel] == image.rgb_stokes[9 * pixel]);
        CHECK(s3_blue[pixel] == image.rgb_stokes[9 * pixel + 8]);
    }
    CHECK(back.text("polarisationHandedness") == "right");
}

TEST_CASE("numbers that are not finite survive in OpenEXR", "[exr]") {
    const ScratchFolder folder;
    Image image = numbered(0, 1);
    image.rgb[0] = std::numeric_limits<float>::quiet_NaN();
    image.rgb[3] = std::numeric_limits<float>::infinity();
    write_exr(image, folder / "a.exr");
    const auto red = ReadBack(folder / "a.exr").channel("R");
    CHECK(std::isnan(red[0]));
    CHECK(std::isinf(red[1]));
}

TEST_CASE("a picture whose planes do not fit its size is not written", "[exr]") {
    const ScratchFolder folder;
    const auto refuses = [&](const Image& image, const std::string& why) {
        CHECK_THROWS_WITH(write_exr(image, folder / "a.exr"), Contains(why));
        CHECK_THROWS_AS(png_bytes(image), Error);
        CHECK(folder.files().empty());
    };
    Image image = numbered(3, 4);
    image.rgb.pop_back();
    refuses(image, "rgb");
    image = numbered(3, 4);
    image.spectral.push_back(0);
    refuses(image, "spectral");
    image = numbered(3, 4);
    image.spectral_components = 3;
    refuses(image, "3 components");
    image = numbered(3, 4);
    std::swap(image.wavelengths_nm[0], image.wavelengths_nm[1]);
    refuses(image, "wavelengths");
    refuses(Image{}, "0 x 0");
}
