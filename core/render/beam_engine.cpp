// From a pixel's footprint to the sampler: beams through stones, leaves to the sky or on as rays.
#include "render/beam_engine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <variant>

#include "beams/footprint.hpp"
#include "beams/roulette.hpp"
#include "beams/tracer.hpp"
#include "render/path_colour.hpp"
#include "render/sky_spectrum.hpp"
#include "render/sky_sum.hpp"
#include "render/survivors.hpp"
#include "render/walker.hpp"

namespace icespar {

struct BeamEngine::Kernels {
    virtual ~Kernels() = default;
    virtual void block(const Frame& pixels, int stone, int samples, std::uint64_t seed,
                       Sampler& sampler, const BeamEngine::Seen& seen) = 0;
    [[nodiscard]] virtual std::uint64_t events() const = 0;
};

namespace {

/// A branch that goes on with this response, about s of any length, where light leaves a stone.
template <class Pair>
Branch continued(const Pair& response, const Vec3& position, const Vec3& k, const Vec3& across,
                 int gem, int hits, bool one_wavelength) {
    Branch b;
    b.position = position;
    b.ray = b.k = normalised(k);
    b.from = {gem, -1};
    const Vec3 s = normalised(across - dot(across, b.ray) * b.ray);
    b.basis = {s, cross(b.ray, s)};
    if constexpr (std::is_same_v<Pair, FullResponse::Pair>) {
        b.amplitude = response.a;
    } else {
        // Any two launched waves of the same sum: S0 does not tell sensor axes apart.
        const auto& r = response;
        const double root = std::sqrt(r.ss);
        if (root > 0) {
            b.amplitude[0] = {root, std::conj(r.sp) / root};
            b.amplitude[1] = {0, std::sqrt(std::max(0.0, r.pp - std::norm(r.sp) / r.ss))};
        } else {
            b.amplitude[0] = {0, std::sqrt(r.pp)};
        }
    }
    b.one_wavelength = one_wavelength;
    b.hits = hits;
    b.weight = b.power();
    return b;
}

template <class Response>
class PixelBeams final : public BeamEngine::Kernels {
public:
    using Mode = typename Response::Single;
    using Tracer = std::variant<
        BeamTracer<Response, false>, BeamTracer<Response, true>, BeamTracer<Response, false, true>,
        BeamTracer<Response, true, true>, BeamTracer<Response, false, false, true>,
        BeamTracer<Response, true, false, true>, BeamTracer<Response, false, true, true>,
        BeamTracer<Response, true, true, true>>;

    PixelBeams(const World& world, const Needs& needs, const BeamScene::Stones& stones,
               const Palette& palette, const WavelengthSampler& wavelengths, int bands, int width,
               int height)
        : world_(world),
          needs_(needs),
          stones_(stones),
          palette_(palette),
          width_(width),
          height_(height),
          walker_(world, palette, needs, false),
          sky_(world.scene().environment, palette, most_pixels) {
        if (needs.wavelengths && !needs.surroundings) {
            // Absorption may change much within a cell.
            const bool coloured = std::any_of(world.scene().gems.begin(), world.scene().gems.end(),
                                              [](const Gem& g) { return g.crystal.absorbs(); });
            spectrum_.emplace(world.scene().environment, palette, wavelengths, bands,
                              Response::stokes ? 4 : 1, coloured ? 128 : 64, most_pixels);
        }
        const std::size_t cells = spectrum_ ? static_cast<std::size_t>(spectrum_->cells()) : 64;
        std::vector<double> nm;
        for (std::size_t i = 0; i < cells * points_a_cell; ++i) {
            const double u =
                (static_cast<double>(i) + 0.5) / static_cast<double>(cells * points_a_cell);
            nm.push_back(wavelengths.draw(u).wavelength_nm);
        }
        for (std::size_t i = 0; i < cells; ++i) {
            cell_colours_.push_back(SkySpectrum::colour(nm[i * points_a_cell + points_a_cell / 2]));
        }
        for (std::size_t i = 0; i < stones.facets.size(); ++i) {
            const StoneNeeds& stone = needs.stones[i];
            tracers_.push_back(tracer_for(stones.facets[i], stone.birefringent,
                                          stone.parts_wavelengths, stone.absorption));
            faint_.emplace_back(stones.facets[i]);
            colours_.emplace_back();
            if (!stone.absorption && !stone.wavelengths) continue;
            const Crystal& crystal = world.scene().gems[i].crystal;
            if (stone.wavelengths) {
                colours_[i].set(crystal, nm, points_a_cell);
            } else {
                colours_[i].set(crystal, {&longest_nm, 1});
            }
        }
    }

    void block(const Frame& pixels, int stone, int samples, std::uint64_t seed, Sampler& sampler,
               const BeamEngine::Seen& seen) override {
        pixels_ = pixels;
        block_ = {pixels.across(), pixels.down()};
        sampler_ = &sampler;
        samples_ = samples;
        threshold_ = 1.0 / samples;
        share_ = 1;
        sampler.begin(seed);
        seed_ = seed;
        next_ = sent_ = 0;
        sampler.inside_threshold = sampler.outside_threshold = 0.1 * threshold_;
        const Scene& scene = world_.scene();
        if (stone == BeamScene::sky) {
            const Point2 middle = pixels.centre();
            field_ = pixel_field(scene.camera, width_, height_, middle.x, middle.y, {});
            background(pixels.corners());
            return finish(seen);
        }
        gem_ = stone;
        const auto g = static_cast<std::size_t>(stone);
        colour_ = &colours_[g];
        const Crystal& crystal = scene.gems[g].crystal;
        const Point2 middle = pixels.centre();
        field_ = pixel_field(scene.camera, width_, height_, middle.x, middle.y,
                             stones_.facets[g].centre());
        stones_.footprints[g].divide(pixels, parts_, count_);
        for (std::size_t i = 0; i < count_; ++i) {
            if (parts_[i].facet < 0) background(parts_[i].polygon);
        }
        if (!needs_.stones[g].wavelengths) {
            roulette_.begin(seed, threshold_);
            trace_stone(crystal, longest_nm);
            add_variances();
        } else {
            follow_spectrum(crystal, seed);
        }
        finish(seen);
    }

    [[nodiscard]] std::uint64_t events() const override {
        std::uint64_t sum = walker_.events();
        for (const FaintRays& f : faint_) sum += f.events();
        for (const auto& t : tracers_) sum += std::visit([](auto& v) { return v.events(); }, t);
        return sum;
    }

    // For the tracer.
    [[nodiscard]] double gain(double weight, int hits) { return roulette_.gain(weight, hits); }
    [[nodiscard]] int stand_in(double weight, double part, int hits) {
        return roulette_.stand_in(weight, part, hits);
    }
    [[nodiscard]] bool may_meet(int hits) const {
        const int most = world_.scene().max_trace_level;
        return most == 0 || hits < most;
    }
    void lose(double weight) { sampler_->dropped += share_ * weight; }
    [[nodiscard]] double transmit(std::span<const Affine> lengths) {
        return colour_->transmit(lengths);
    }
    void absorb(double weight) { sampler_->absorbed += share_ * weight; }
    void open() { std::fill_n(seen_.begin(), count(), 0.0); }
    void close(int hits) { roulette_.saw(hits, {seen_.data(), count()}); }
    [[nodiscard]] bool survivors_are_rays() const {
        return needs_.stones[static_cast<std::size_t>(gem_)].faint_rays;
    }
    int survive(int hits, const Mode& response) {
        survivors_.add(hits, response);
        return rays_of_survivor();
    }
    [[nodiscard]] double uniform() { return roulette_.uniform(); }
    void send(const FaintRays::Ray& ray, std::size_t pixel) {
        survivors_.send(ray, pixel, mixed(seed_ + sent_++), rays_of(gem_));
    }
    void see(const Leaf<Response>& leaf) {
        if (!needs_.surroundings) {
            const Stokes response = leaf.response.unpolarised();
            cutter_.cut(block_, leaf.polygon, leaf.centre, leaf.area,
                        [&](std::size_t pixel, PolygonView polygon, double area, const Point2& at) {
                            Expansion k = leaf.k;
                            if (count() > 1) k = {normalised(k.at(at)), k.dx, k.dy};
                            if (!spectral_) {
                                seen_[pixel] += sky_.add(pixel, k, polygon, area, response);
                                return;
                            }
                            const bool tinted =
                                needs_.stones[static_cast<std::size_t>(gem_)].absorption;
                            seen_[pixel] += spectrum_->add(
                                pixel, k, leaf.fan, polygon, area, response,
                                tinted ? colour_->tint() : std::span<const double>{});
                        });
            return;
        }
        const double weight = leaf.area * leaf.response.power();
        const int rays = std::max(1, static_cast<int>(std::lround(weight * samples_)));
        for (int i = 0; i < rays; ++i) {
            const CameraSample at = camera_sample(seed_, next_++);
            const Point2 p = point_in(leaf.polygon, at.x, at.y);
            go_on(leaf.response, leaf.position.at(p), leaf.k.at(p), leaf.fan, leaf.s, leaf.hits,
                  leaf.area / rays, at);
        }
    }

private:
    [[nodiscard]] static Tracer tracer_for(const FacetSearch& facets, bool birefringent,
                                           bool spectral, bool absorbing) {
        const auto either = [](bool first, auto choose) {
            return first ? choose(std::true_type{}) : choose(std::false_type{});
        };
        return either(birefringent, [&](auto b) {
            return either(spectral, [&](auto s) {
                return either(absorbing, [&](auto a) {
                    return Tracer(
                        std::in_place_type<BeamTracer<Response, b.value, s.value, a.value>>,
                        facets);
                });
            });
        });
    }

    /// Each path is that of a piece of the spectrum (bench/beams.cpp).
    void follow_spectrum(const Crystal& crystal, std::uint64_t seed) {
        spectral_ = true;
        const int cells = static_cast<int>(cell_colours_.size());
        // Colours that go the same way need one path. No piece is empty.
        const bool parts = needs_.stones[static_cast<std::size_t>(gem_)].parts_wavelengths;
        const auto wanted = static_cast<int>(std::lround(0.6 * std::sqrt(samples_)));
        const int pieces = parts ? std::clamp(wanted, 1, cells / 2) : 1;
        const double shift = 0.5 * (sampler_->uniform() - 0.5);
        int first = 0;
        for (int i = 0; i < pieces; ++i) {
            const int last = i + 1 == pieces
                                 ? cells
                                 : static_cast<int>(std::lround(cells * (i + 1 + shift) / pieces));
            share_ = static_cast<double>(last - first) / cells;
            roulette_.begin(mixed(seed + static_cast<unsigned>(i)),
                            std::min(1.0, threshold_ / (pieces * share_)));
            colour_->narrow(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
            trace_stone(crystal, begin_piece(first, last));
            add_variances();
            first = last;
        }
        spectral_ = false;
    }

    /// The wavelength of the paths for these cells.
    double begin_piece(int first, int last) {
        if (spectrum_) return spectrum_->begin(first, last);
        const auto colours = cell_colours_.begin();
        middle_ = std::accumulate(colours + first, colours + last, 0.0) / (last - first);
        return SkySpectrum::wavelength_nm(middle_);
    }

    /// Light that leaves the stone goes on as a ray of one wavelength of its piece.
    void go_on(const typename Response::Pair& response, const Vec3& position, const Vec3& k,
               const Vec3& fan, const Vec3& s, int hits, double share, const CameraSample& at) {
        const double drawn = spectral_ ? colour_->draw(at.wavelength) : at.wavelength;
        sampler_->at_wavelength(drawn);
        const double nm = sampler_->wavelength_nm();
        const Vec3 apart = spectral_ ? (SkySpectrum::colour(nm) - middle_) * fan : Vec3{};
        const double exact = spectral_ ? colour_->correction(drawn, nm) : 1;
        const Vec3& centre = stones_.facets[static_cast<std::size_t>(gem_)].centre();
        Branch b = continued(response, position + centre, k + apart, s, gem_, hits, spectral_);
        follow(b, exact * share_ * share);
    }

    void follow(Branch& b, double share) {
        b.scale(share);
        walker_.walk(b, sampler_->wavelength_nm(), *sampler_);
    }

    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(pixels_.count()); }

    void add_variances() {
        for (std::size_t i = 0; i < count(); ++i) variances_[i] += roulette_.variance(i);
    }

    /// Hands out each pixel.
    void finish(const BeamEngine::Seen& seen) {
        for (std::size_t i = 0; i < count(); ++i) {
            const int at = static_cast<int>(i);
            if (!needs_.surroundings) {
                std::fill(sampler_->sample.begin(), sampler_->sample.end(), 0.0);
                sky_.flush(i, palette_, *sampler_);
                if (spectrum_) spectrum_->flush(i, *sampler_);
            }
            seen(pixels_.x0 + at % pixels_.across(), pixels_.y0 + at / pixels_.across(),
                 needs_.surroundings ? -1 : variances_[i]);
            variances_[i] = 0;
        }
    }

    void trace_stone(const Crystal& crystal, double nm) {
        const IndexFunction &o = crystal.indices.front(), &e = crystal.indices.back();
        const Medium medium = crystal.birefringent() ? Medium::uniaxial(o(nm), e(nm), crystal.axis)
                                                     : Medium::isotropic(o(nm));
        const auto change = [&](const IndexFunction& n) {
            constexpr double step = 1e-3;
            const double c = SkySpectrum::colour(nm);
            return (n(SkySpectrum::wavelength_nm(c + step)) -
                    n(SkySpectrum::wavelength_nm(c - step))) /
                   (2 * step);
        };
        std::visit(
            [&](auto& tracer) {
                tracer.set_medium(medium, change(o), change(e));
                if (crystal.birefringent()) {
                    rays_of(gem_).set_medium(medium, spectral_, change(o), change(e));
                }
                tracer.set_block(block_, unevenness * std::pow(threshold_, 0.75));
                for (std::size_t i = 0; i < count_; ++i) {
                    if (parts_[i].facet < 0) continue;
                    tracer.trace(field_, world_.scene().camera.right, parts_[i].polygon,
                                 parts_[i].facet, *this);
                }
            },
            tracers_[static_cast<std::size_t>(gem_)]);
        if (crystal.birefringent()) follow_rays();
    }

    /// docs/method.md
    [[nodiscard]] int rays_of_survivor() const { return needs_.surroundings ? 1 : 4; }

    [[nodiscard]] FaintRays& rays_of(int gem) { return faint_[static_cast<std::size_t>(gem)]; }

    void follow_rays() {
        FaintRays& rays = rays_of(gem_);
        lose(survivors_.follow(rays, roulette_.threshold() / rays_of_survivor(),
                               world_.scene().max_trace_level, count(), roulette_,
                               [&](std::size_t pixel, const FaintRays::Exit& e,
                                   const Mode& response) { return see_exit(pixel, e, response); }));
    }

    /// The luminance, below a sky alone.
    double see_exit(std::size_t pixel, const FaintRays::Exit& e, const Mode& response) {
        if (needs_.surroundings) {
            const double size = 1 / std::hypot(e.out_s, e.out_p);
            go_on(response.leaving(size * e.out_s, size * e.out_p), e.position, e.k, e.fan, e.s,
                  e.hits, e.weight, camera_sample(seed_, next_++));
            return 0;
        }
        const Stokes seen = response.leaving(1, 0).unpolarised();
        const Expansion k{e.k, {}, {}};
        return spectral_ ? spectrum_->add(pixel, k, e.fan, {}, e.weight, seen)
                         : sky_.add(pixel, k, {}, e.weight, seen);
    }

    void background(PolygonView polygon) {
        const Extent e = extent(polygon);
        if (!needs_.surroundings) {
            corners_.assign(polygon.begin(), polygon.end());
            for (Point2& p : corners_) p = p - e.centroid;
            cutter_.cut(block_, corners_, e.centroid, e.area,
                        [&](std::size_t pixel, PolygonView part, double area, const Point2& at) {
                            const Expansion line = field_.direction.about(e.centroid);
                            const double size = length(line.at(at));
                            const Vec3 unit = line.at(at) / size;
                            const auto turned = [&](const Vec3& d) {
                                return (d - dot(unit, d) * unit) / size;
                            };
                            sky_.add(pixel, {unit, turned(line.dx), turned(line.dy)}, part, area,
                                     {1, 0, 0, 0});
                        });
            return;
        }
        const int rays = std::max(1, static_cast<int>(std::lround(e.area * samples_)));
        const Vec3& centre = stones_.facets[static_cast<std::size_t>(gem_)].centre();
        for (int i = 0; i < rays; ++i) {
            const CameraSample at = camera_sample(seed_, next_++);
            const Point2 p = point_in(polygon, at.x, at.y);
            Branch b = Branch::from_sensor(field_.origin.at(p) + centre,
                                           normalised(field_.direction.at(p)),
                                           world_.scene().camera.right);
            sampler_->at_wavelength(at.wavelength);
            follow(b, e.area / rays);
        }
    }

    const World& world_;
    const Needs& needs_;
    const BeamScene::Stones& stones_;
    const Palette& palette_;
    int width_, height_;
    Walker<Sampler> walker_;
    SkySum sky_;
    std::optional<SkySpectrum> spectrum_;  ///< below a sky, where stones disperse
    static constexpr std::size_t most_pixels = Roulette::most_pixels;
    std::array<double, most_pixels> seen_{}, variances_{};  ///< luminance since a beam was opened
    std::vector<Tracer> tracers_;                           ///< of each stone
    std::vector<PathColour> colours_;                       ///< of each stone
    PathColour* colour_ = nullptr;                          ///< of the stone that is followed
    Roulette roulette_;
    std::vector<FaintRays> faint_;  ///< of each stone
    Survivors<Mode> survivors_;
    Sampler* sampler_ = nullptr;
    RayField field_;
    std::vector<Footprint::Part> parts_;
    std::size_t count_ = 0;
    Polygon corners_;
    PixelCutter cutter_;
    Frame pixels_;
    Block block_;
    static constexpr std::size_t points_a_cell = 8;
    static constexpr double unevenness = 2;  ///< (docs/method.md)
    int gem_ = 0, samples_ = 1;
    double threshold_ = 1, share_ = 1;
    bool spectral_ = false;             ///< paths stand for pieces of the spectrum
    std::vector<double> cell_colours_;  ///< of narrow bands that pieces are made of
    double middle_ = 0;                 ///< colour of the paths, where they go on as rays
    std::uint64_t seed_ = 0, next_ = 0,
                  sent_ = 0;  ///< of the block; numbers of its next ray outside and inside
};

}  // namespace

BeamEngine::BeamEngine(const BeamScene& scene, const Palette& palette,
                       const WavelengthSampler& wavelengths, int bands) {
    if (scene.needs_.stokes) {
        kernels_ = std::make_unique<PixelBeams<FullResponse>>(scene.world_, scene.needs_,
                                                              scene.stones_, palette, wavelengths,
                                                              bands, scene.width_, scene.height_);
    } else {
        kernels_ = std::make_unique<PixelBeams<IntensityResponse>>(
            scene.world_, scene.needs_, scene.stones_, palette, wavelengths, bands, scene.width_,
            scene.height_);
    }
}

BeamEngine::~BeamEngine() = default;
BeamEngine::BeamEngine(BeamEngine&&) noexcept = default;

void BeamEngine::block(const Frame& pixels, int stone, int samples, std::uint64_t seed,
                       Sampler& sampler, const Seen& seen) {
    kernels_->block(pixels, stone, samples, seed, sampler, seen);
}

std::uint64_t BeamEngine::events() const { return kernels_->events(); }

}  // namespace icespar
