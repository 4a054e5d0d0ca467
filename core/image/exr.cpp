// OpenEXR files: RGB, Stokes components and spectral bands, each a channel of floats.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <array>
#include <charconv>

#include "image/checked_file.hpp"
#include "image/image.hpp"
#include "image/layout.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

class Stream : public Imf::OStream {
public:
    Stream(CheckedFile& file, const std::string& name) : OStream(name.c_str()), file_(file) {}
    void write(const char bytes[], int count) override {
        file_.write(bytes, static_cast<std::size_t>(count));
        position_ += static_cast<std::uint64_t>(count);
    }
    /// Never throws: OpenEXR asks in a destructor.
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override {
        file_.seek(position);
        position_ = position;
    }

private:
    CheckedFile& file_;
    std::uint64_t position_ = 0;
};

/// "560,000000nm": a comma, because a dot parts the layers of a channel's name.
std::string band_name(double nm) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), nm, std::chars_format::fixed, 6).ptr;
    std::string name(text.data(), end);
    name.replace(name.find('.'), 1, ",");
    return name + "nm";
}

/// The header and the places of the pixels, filled channel by channel.
struct Channels {
    Imf::Header header;
    Imf::FrameBuffer places;

    /// The channel's values are `first[pixel * stride]`.
    void add(const std::string& name, const float* first, std::size_t stride) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        // OpenEXR only reads through this pointer when it writes a file.
        places.insert(name,
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(first)),
                                 stride * sizeof(float),
                                 stride * sizeof(float) * static_cast<std::size_t>(width)));
    }

    int width;
};

Channels channels_of(const Image& image) {
    Channels c{Imf::Header(image.width, image.height), {}, image.width};
    const std::array<std::string, 3> colours{"R", "G", "B"};
    for (std::size_t i = 0; i < 3; ++i) c.add(colours[i], image.rgb.data() + i, 3);

    if (!image.rgb_stokes.empty())
        for (std::size_t i = 0; i < 3; ++i) {
            c.add("S0." + colours[i], image.rgb.data() + i, 3);
            for (std::size_t s = 1; s <= 3; ++s)
                c.add("S" + std::to_string(s) + "." + colours[i],
                      image.rgb_stokes.data() + 3 * i + s - 1, 9);
        }

    const auto components = static_cast<std::size_t>(image.spectral_components);
    const std::size_t bands = image.wavelengths_nm.size();
    for (std::size_t band = 0; band < bands; ++band)
        for (std::size_t s = 0; s < components; ++s)
            c.add("S" + std::to_string(s) + "." + band_name(image.wavelengths_nm[band]),
                  image.spectral.data() + band * components + s, bands * components);
    return c;
}

void add_attributes(Imf::Header& header, const Image& image) {
    const auto text = [&](const std::string& name, const std::string& value) {
        header.insert(name, Imf::StringAttribute(value));
    };
    Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709, D65
    if (!image.wavelengths_nm.empty()) {
        text("spectralLayoutVersion", "1.0");
        text("emissiveUnits", "W.m^-2.sr^-1");
    }
    if (!image.rgb_stokes.empty() || image.spectral_components == 4)
        text("polarisationHandedness", "right");
    for (const auto& [name, value] : image.metadata) text("icespar:" + name, value);
}

}  // namespace

void write_exr(const Image& image, const std::string& path) {
    check_layout(image);
    write_whole(path, [&](const std::string& partial) {
        CheckedFile file(partial, path);
        try {
            Stream stream(file, path);
            Channels channels = channels_of(image);
            channels.header.compression() = Imf::ZIP_COMPRESSION;
            add_attributes(channels.header, image);
            Imf::OutputFile output(stream, channels.header);
            output.setFrameBuffer(channels.places);
            output.writePixels(image.height);
        } catch (const Error&) {
            throw;
        } catch (const std::exception& e) {
            throw Error("cannot write '" + path + "' as OpenEXR: " + e.what() +
                        "; check the picture's metadata and size");
        }
        file.close();
    });
}

}  // namespace icespar
