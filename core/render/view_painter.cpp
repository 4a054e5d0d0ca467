// Each exit of the view is lit once, and its polygon drawn with exact coverage.
#include "render/view_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "beams/response.hpp"
#include "math/random.hpp"
#include "render/sampler.hpp"
#include "render/sky_light.hpp"
#include "render/stone_optics.hpp"
#include "views/shading.hpp"

namespace icespar {
namespace {

/// So many beams, followed exactly, wait in about a gigabyte; a batch shares it.
constexpr std::uint64_t most_beams = 1'000'000;
/// Less of the light than this need not be sampled to be a good picture.
constexpr double default_bound = 1e-3;
/// Pixels across which the transmission of a beam may vary.
constexpr double least_shaded = 2;

/// From the picture of a view, in the stone's units, to pixels from the top left.
class PixelMap {
public:
    PixelMap(const Camera& camera, int width, int height, const PictureFrame& frame) {
        const double volume = dot(camera.direction, cross(camera.right, camera.up));
        const Vec3 u = (width / volume) * cross(camera.up, camera.direction),
                   v = (-height / volume) * cross(camera.direction, camera.right);
        const Vec3 middle = frame.centre - camera.location;
        x_ = {dot(middle, u) + 0.5 * width, dot(frame.right, u), dot(frame.up, u)};
        y_ = {dot(middle, v) + 0.5 * height, dot(frame.right, v), dot(frame.up, v)};
    }
    [[nodiscard]] Point2 of(const Point2& p) const { return {x_(p), y_(p)}; }
    /// A number of the view's as one of pixels.
    [[nodiscard]] Affine of(const Affine& f) const {
        const double volume = x_.dx * y_.dy - x_.dy * y_.dx;
        const double dx = (f.dx * y_.dy - f.dy * y_.dx) / volume,
                     dy = (f.dy * x_.dx - f.dx * x_.dy) / volume;
        return {f.value - dx * x_.value - dy * y_.value, dx, dy};
    }
    /// Pixels per unit of area.
    [[nodiscard]] double scale() const { return std::abs(x_.dx * y_.dy - x_.dy * y_.dx); }

private:
    Affine x_, y_;
};

/// The same lights, with the colour of what they have between two of the sampler's wavelengths: it
/// is exact however few there are.
Palette between(Palette palette, double u0, double u1, const WavelengthSampler& wavelengths,
                const Bands& bands) {
    constexpr int draws = 32;
    const double share = (u1 - u0) / draws;
    std::vector<WavelengthSampler::Draw> at;
    for (int i = 0; i < draws; ++i) at.push_back(wavelengths.draw(u0 + (i + 0.5) * share));
    const auto restricted = [&](Emitter& e) {
        e.rgb = {};
        std::fill(e.bands.begin(), e.bands.end(), 0.0);
        for (const WavelengthSampler::Draw& d : at) {
            const double value = share * e.radiance(d.wavelength_nm);
            for (std::size_t c = 0; c < 3; ++c) e.rgb[c] += value * d.rgb[c];
            if (bands.count == 0) continue;
            e.bands[static_cast<std::size_t>(bands.of(d.wavelength_nm))] +=
                value * d.per_density / bands.width();
        }
    };
    for (Emitter* e : {&palette.below, &palette.above, &palette.illuminant}) restricted(*e);
    for (Emitter& e : palette.sky) restricted(e);
    for (Emitter& e : palette.discs) restricted(e);
    return palette;
}

bool polarised(const Environment& sky) {
    return sky.state != Stokes{1, 0, 0, 0} || sky.formulas.size() > 1;
}

/// What is seen of light from one direction.
struct Response {
    Stokes unpolarised;
    std::array<Stokes, 3> polarised{};
    Vec3 axis{};

    /// Of a Stokes vector on axes of which y is towards `up`.
    [[nodiscard]] Stokes seen(const Stokes& light, const Vec3& direction, const Vec3& up) const {
        if (light.s1 == 0 && light.s2 == 0 && light.s3 == 0) return light.s0 * unpolarised;
        const Vec3 y = up_across(direction, up), x = cross(direction, y);
        const double c = dot(axis, x), s = dot(axis, y), cos2 = c * c - s * s, sin2 = 2 * c * s;
        return light.s0 * unpolarised + (cos2 * light.s1 + sin2 * light.s2) * polarised[0] +
               (cos2 * light.s2 - sin2 * light.s1) * polarised[1] + light.s3 * polarised[2];
    }
};

/// Beside the stone.
Response beside(const PictureFrame& frame, const std::optional<Jones>& analyser) {
    const auto pair = analyser ? FullResponse::Pair::behind(*analyser) : FullResponse::Pair{};
    const FullResponse::Pair across = pair.times(1, -1);
    return {across.unpolarised(),
            {across.seen({0, 1, 0, 0}), across.seen({0, 0, 1, 0}), across.seen({0, 0, 0, 1})},
            frame.right};
}

std::vector<double> channels(const Emitter& light) {
    std::vector<double> out(light.rgb.begin(), light.rgb.end());
    out.insert(out.end(), light.bands.begin(), light.bands.end());
    return out;
}

}  // namespace

int parts_of(const Crystal& crystal) {
    constexpr int parted = 16, together = 4;
    return !crystal.dispersive() ? 1 : crystal.parts_wavelengths() ? parted : together;
}

RealTensor ViewPainter::change(const Crystal& crystal, double u0, double u1) const {
    const auto eps = [&](double u) {
        const StoneOptics at(crystal, wavelengths_.draw(u).wavelength_nm);
        return real(at.medium().permittivity());
    };
    return eps(u1) + -1.0 * eps(u0);
}

std::vector<ViewPainter::Hue> ViewPainter::hues_of(const Crystal& crystal, int i, int parts) const {
    constexpr int wavelengths = 64;
    const int count = parts > 1 ? std::max(1, wavelengths / parts) : 1;
    const double share = 1.0 / parts, step = share / count, first = i * share;
    const RealTensor whole = change(crystal, first, first + share);
    const double size2 = product(whole, whole);
    std::vector<Hue> out;
    for (int h = 0; h < count; ++h) {
        const double from = first + h * step, middle = from + 0.5 * step;
        const double part = product(change(crystal, first + 0.5 * share, middle), whole);
        const StoneOptics optics(crystal, wavelengths_.draw(middle).wavelength_nm);
        out.push_back({size2 > 0 ? part / size2 : 0, optics.absorption(),
                       parts == 1
                           ? palette_
                           : between(palette_, from, from + step, wavelengths_, film_.bands())});
    }
    return out;
}

std::vector<double> ViewPainter::white() const { return channels(palette_.illuminant); }

void PaintedPart::add(const PaintedPart& other) {
    dropped += other.dropped;
    absorbed += other.absorbed;
    variance += other.variance;
    beams += other.beams;
    white.resize(other.white.size());
    for (std::size_t c = 0; c < white.size(); ++c) white[c] += other.white[c];
}

ViewPainter::ViewPainter(const Scene& scene, const Palette& palette,
                         const WavelengthSampler& wavelengths, const RenderOptions& options,
                         const Film& film, int pass)
    : scene_(scene),
      palette_(palette),
      wavelengths_(wavelengths),
      options_(options),
      film_(film),
      values_(film.channels() * film.components()),
      pass_(pass) {
    const Camera& camera = scene.camera;
    const Vec3 d = normalised(camera.direction);
    view_ = {d, cross(camera.right - dot(camera.right, d) * d, d)};
}

PaintedPart ViewPainter::paint(int i, int parts, const std::function<bool()>& go_on,
                               Raster& raster) const {
    const double share = 1.0 / parts;
    Sampler sampler(film_, wavelengths_, 0);
    sampler.at_wavelength((i + 0.5) * share);
    const Gem& gem = scene_.gems[0];
    const std::vector<Hue> hues = hues_of(gem.crystal, i, parts);
    ViewOptions options = how(parts, pixels_of(gem.stone), go_on);
    options.seed = mixed(mixed(mixed(options_.seed) + static_cast<std::uint64_t>(pass_)) +
                         static_cast<std::uint64_t>(i));
    if (hues.size() > 1 && gem.crystal.parts_wavelengths()) {
        options.fan = change(gem.crystal, i * share, (i + 1) * share);
    }
    std::vector<Absorption> absorption;
    for (const Hue& hue : hues) absorption.push_back(hue.absorption);
    const StoneOptics optics(gem.crystal, sampler.wavelength_nm());
    const Exits part = trace_view(gem.stone, optics.medium(), view_, options, absorption);
    const Exits exits = part.expanded();
    const PixelMap map(scene_.camera, film_.width(), film_.height(), exits.frame);

    const auto lit = [&](const Vec3& direction, const Response& response,
                         const Palette& palette) -> const std::vector<double>& {
        sampler.begin(0);
        sky_light(
            scene_.environment, palette, direction,
            [&](const Stokes& stokes, const Vec3& up) {
                return response.seen(stokes, direction, up);
            },
            [&](const Emitter& emitter, const Stokes& seen) { sampler.see(emitter, seen, false); });
        return sampler.sample;
    };
    const Palette colours =
        parts == 1 ? palette_
                   : between(palette_, i * share, (i + 1) * share, wavelengths_, film_.bands());
    const std::vector<double> background =
        lit(exits.frame.direction, beside(exits.frame, scene_.camera.analyser), colours);
    const double right = film_.width(), bottom = film_.height();
    const Point2 corners[] = {{0, 0}, {right, 0}, {right, bottom}, {0, bottom}};
    raster.add(corners, background);
    Polygon polygon;
    PaintedPart out;
    std::vector<std::vector<double>> shares(hues.size());  // of one exit, by hue
    std::vector<double> sample(background.size());
    std::vector<Affine> depths(hues.size());
    for (std::size_t e = 0; e < exits.size(); ++e) {
        Response response{exits.weight[e]};
        if (!exits.polarised.empty()) {
            response.polarised = exits.polarised[e];
            response.axis = exits.axis[e];
        }
        polygon.clear();
        for (std::size_t c = exits.outline[e]; c < exits.outline[e + 1]; ++c) {
            polygon.push_back(map.of(exits.corners[c]));
        }
        if (exits.hits[e] == 1) {
            // What the stone's outside mirrors stands before the background.
            sample = lit(exits.direction[e], response, colours);
            for (std::size_t v = 0; v < sample.size(); ++v) sample[v] -= background[v];
            raster.add(polygon, sample);
            continue;
        }
        std::fill(sample.begin(), sample.end(), 0.0);
        const auto tint = exits.tint_of(e);
        for (std::size_t h = 0; h < hues.size(); ++h) {
            const Vec3 fan = exits.fan.empty() ? Vec3{} : hues[h].place * exits.fan[e];
            shares[h] = lit(normalised(exits.direction[e] + fan), response, hues[h].colours);
            for (std::size_t v = 0; v < sample.size(); ++v) {
                if (!tint.empty()) shares[h][v] *= tint[h];
                sample[v] += shares[h][v];
            }
        }
        const double area = std::abs(extent(polygon).area);
        if (exits.group[e] > 0) out.variance += squares(sample, area);
        if (exits.lengths.empty() || area < least_shaded) {
            raster.add(polygon, sample);
            continue;
        }
        for (std::size_t h = 0; h < hues.size(); ++h) depths[h] = map.of(exits.depth(e, h));
        shade(polygon, depths, shares, sample, raster);
    }
    const double per_pixel = share * map.scale() / (right * bottom);
    out.dropped = per_pixel * (exits.residue + exits.cut);
    out.absorbed = per_pixel * exits.absorbed;
    out.beams = exits.beams;
    out.white = channels(colours.illuminant);
    return out;
}

/// A beam of the sample stands for others that lie about it as likely: by how much its light
/// adds to the squared errors of pixels of the size 1, on which it may lie anyhow, as a square of
/// its area would. Beams that come of one another also lie upon each other, which adds about a
/// seventh (measured, in stones of all kinds).
double ViewPainter::squares(const std::vector<double>& sample, double area) const {
    constexpr double stacked = 1.15;
    const auto step = static_cast<std::size_t>(film_.components());
    const double light = xyz_from_rgb({sample[0], sample[step], sample[2 * step]})[1];
    const double side = std::sqrt(area);
    const double covered = side < 1 ? area * (1 - side / 3) : side - 1.0 / 3;
    return stacked * light * light * covered * covered;
}

/// Pixels that the stone covers in the view.
double ViewPainter::pixels_of(const Stone& stone) const {
    const Camera& c = scene_.camera;
    double area = 0;
    for (const Facet& f : stone.facets)
        area += 0.5 * f.area * std::abs(dot(f.normal, view_.direction));
    const double picture = std::abs(dot(view_.direction, cross(c.right, c.up)));
    return area / picture * film_.width() * film_.height();
}

/// Of one of so many parts of the spectrum, whose errors are their own.
ViewOptions ViewPainter::how(int parts, double pixels, const std::function<bool()>& go_on) const {
    ViewOptions options;
    // Survivors of the sample are spread over the pixels, and are about as large.
    constexpr double spread = 0.7, least_error = 1e-9;
    const double error = options_.error > 0 ? options_.error : exact_error;
    options.error = spread * error * std::sqrt(parts / std::max(1.0, pixels));
    if (options_.error == 0 && options_.seconds > 0) options.error = least_error;
    options.bound = {};
    if (options_.error == 0 && options_.seconds == 0 && parts == 1) options.bound = default_bound;
    options.max_beams = parts > 1 ? most_beams / batch : most_beams;
    constexpr double exact_part = 0.4;
    // Beams that wait take memory, a sample takes time.
    constexpr double effort = 4;
    if (options_.seconds == 0) options.sample_effort = effort;
    options.seconds = exact_part * options_.seconds / parts;
    options.max_hits = scene_.max_trace_level;
    options.outlines = true;
    options.polarised = polarised(scene_.environment);
    options.analyser = scene_.camera.analyser;
    options.weights = film_.components() == 4 ? Weights::stokes : Weights::intensity;
    options.go_on = go_on;
    return options;
}

}  // namespace icespar
