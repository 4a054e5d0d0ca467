// The tree of light behind a sensor ray: every facet splits a branch, a guide says which are worth
// following.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "render/branch.hpp"
#include "render/lamp.hpp"
#include "render/needs.hpp"
#include "render/palette.hpp"
#include "render/pass_filter.hpp"
#include "render/random.hpp"
#include "render/sky_light.hpp"
#include "render/stone_optics.hpp"
#include "render/surface.hpp"
#include "render/twins.hpp"

namespace icespar {

/// Walks depth first, or heaviest branch first. The guide decides and collects:
///
///   admit(Branch&)                  false drops a branch; one that survives roulette gains weight
///   may_meet(branch)                false: the branch ends before its next interface event
///   lose(stokes)                    the response of a branch given up without roulette
///   absorb(stokes)                  the response of light that ends within a stone
///   see(emitter, stokes, at_one)    light that arrives; at_one: only at the traced wavelength
///   see_at_wavelength(L, stokes)    spectral radiance L at the traced wavelength
///   light_point()                   where on the unit square an area light is asked
///   diffuse_rays(branch)            how many rays a diffuse surface sends on
///   diffuse_point(ray, rays)        where in the unit square ray number `ray` of them is drawn
template <class Guide>
class Walker {
public:
    Walker(const World& world, const Palette& palette, const Needs& needs, bool heaviest_first)
        : world_(world), palette_(palette), needs_(needs.stones), heaviest_first_(heaviest_first) {
        stones_.resize(world.scene().gems.size());
    }

    std::uint64_t events() const { return events_; }

    void walk(const Branch& first, double wavelength_nm, Guide& guide) {
        wavelength_nm_ = wavelength_nm;
        branches_.clear();
        twins_.clear();
        push(first, guide);
        while (!branches_.empty()) {
            if (heaviest_first_) std::pop_heap(branches_.begin(), branches_.end(), lighter);
            Branch branch = branches_.back();
            branches_.pop_back();
            if (branch.gem >= 0) {
                follow_inside(branch, guide);
            } else {
                follow_outside(branch, guide);
            }
        }
    }

private:
    static bool lighter(const Branch& a, const Branch& b) { return a.weight < b.weight; }

    void push(const Branch& branch, Guide& guide) {
        branches_.push_back(branch);
        if (!guide.admit(branches_.back())) {
            branches_.pop_back();
        } else if (heaviest_first_) {
            std::push_heap(branches_.begin(), branches_.end(), lighter);
        }
    }

    const StoneNeeds& needs(int gem) const { return needs_[static_cast<std::size_t>(gem)]; }

    const StoneOptics& optics(int gem) {
        StoneOptics& stone = stones_[static_cast<std::size_t>(gem)];
        const StoneNeeds& need = needs(gem);
        const bool stale = stone.wavelength_nm() == 0 || need.wavelengths || need.active;
        if (stale && stone.wavelength_nm() != wavelength_nm_) {
            stone = StoneOptics(world_.scene().gems[static_cast<std::size_t>(gem)].crystal,
                                wavelength_nm_, need.general);
        }
        return stone;
    }

    void follow_inside(Branch& b, Guide& guide) {
        if (!guide.may_meet(b)) return guide.lose(b.unpolarised());
        if (b.twin >= 0) return follow_twins(b, guide);
        double distance = 0;
        const int facet = world_.planes(b.gem).exit(b.position, b.ray, b.facet, distance);
        if (facet < 0) return guide.lose(b.unpolarised());
        const StoneOptics& within = optics(b.gem);
        if (needs(b.gem).absorption) absorb(b, within, distance, guide);
        const Stone& stone = world_.scene().gems[static_cast<std::size_t>(b.gem)].stone;
        meet_face(b, b.position + distance * b.ray, within.medium(), air_,
                  stone.facets[static_cast<std::size_t>(facet)].normal, b.gem, facet, guide);
    }

    void absorb(Branch& b, const StoneOptics& within, double distance, Guide& guide) {
        const double left = within.transmittance(
            b.k, b.ray, b.basis[0], within.medium().plain() ? Vec3{} : b.basis[1], distance);
        guide.absorb((1 - left) * b.unpolarised());
        b.scale(left);
    }

    /// Light along the axis of an active stone turns because its two modes keep step: while both
    /// meet the same facet, and leave it as one wave would, they are added as fields. Elsewhere
    /// they part for good.
    void follow_twins(const Branch& b, Guide& guide) {
        const Twin twin = twins_[static_cast<std::size_t>(b.twin)];
        Branch fast = b, slow = b;
        fast.twin = slow.twin = -1;
        slow.mode = Mode::slow;
        slow.k = twin.k;
        slow.ray = twin.ray;
        slow.basis = twin.basis;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            fast.amplitude[axis] = {b.amplitude[axis][0], 0};
            slow.amplitude[axis] = {b.amplitude[axis][1], 0};
        }
        const double response = b.diffused ? b.response.s0 : 1;
        fast.weight = fast.power() * response;
        slow.weight = slow.power() * response;
        double distance = 0, other = 0;
        const int facet = world_.planes(b.gem).exit(b.position, b.ray, b.facet, distance);
        if (facet >= 0 &&
            facet == world_.planes(b.gem).exit(b.position, twin.ray, b.facet, other)) {
            if (meet_as_one(fast, slow, distance, facet, guide)) return;
        }
        follow_inside(fast, guide);
        follow_inside(slow, guide);
    }

    void follow_outside(const Branch& b, Guide& guide) {
        Hit hit;
        if (!world_.nearest({b.position, b.ray}, b.from, hit)) return see_environment(b, guide);
        const Vec3 point = b.position + hit.distance * b.ray;
        if (hit.thing >= 0) {
            const bool sheet =
                world_.scene().things[static_cast<std::size_t>(hit.thing)].filter.has_value();
            return sheet ? meet_sheet(b, point, hit, guide) : meet_thing(b, point, hit, guide);
        }
        if (!guide.may_meet(b)) return guide.lose(b.unpolarised());
        const Stone& stone = world_.scene().gems[static_cast<std::size_t>(hit.gem)].stone;
        meet_face(b, point, air_, optics(hit.gem).medium(),
                  -stone.facets[static_cast<std::size_t>(hit.facet)].normal, hit.gem, hit.facet,
                  guide);
    }

    /// The event itself: one branch becomes up to four, whose powers sum to its own.
    void meet_face(const Branch& b, const Vec3& point, const Medium& from, const Medium& to,
                   const Vec3& normal, int gem, int facet, Guide& guide) {
        ++events_;
        Wave incident;
        if (from.plain()) {
            incident.mode = b.gem >= 0 && from.birefringent ? b.mode : Mode::s;
            incident.k = complexified(b.k);
            incident.E = complexified(b.basis[0]);
            // The general solver takes the field as that of the mode named.
            if (!to.plain())
                incident = plane_wave(from, Mode::s, normalised(b.k), By::wave_normal, normal);
        } else {
            incident = wave_of(b, from);
        }
        const Interface face(from, to, normal, incident);

        // Amplitudes of the incident waves: one mode of a crystal, or s and p of an isotropic
        // medium.
        auto incoming = b.amplitude;
        std::size_t first = 0, last = 1;
        if (from.birefringent) {
            first = last = mode_index(b.mode);
            for (auto& row : incoming) row = {row[0], row[0]};
        } else {
            const Vec3& s = face.s_direction();
            const Vec3 p = cross(b.k, s) / from.n_o;
            const double s0 = dot(s, b.basis[0]), s1 = dot(s, b.basis[1]);
            const double p0 = dot(p, b.basis[0]), p1 = dot(p, b.basis[1]);
            for (auto& row : incoming) {
                row = {row[0] * s0 + row[1] * s1, row[0] * p0 + row[1] * p1};
            }
        }

        Branch child = b;
        child.position = point;
        child.twin = -1;
        child.hits = b.hits + 1;
        child.one_wavelength = b.one_wavelength || needs(gem).wavelengths;
        for (const bool transmitted : {false, true}) {
            const Medium& medium_out = transmitted ? to : from;
            const bool inside = (b.gem >= 0) != transmitted;
            child.gem = inside ? gem : -1;
            child.facet = facet;
            child.from = {gem, -1};
            if (medium_out.active() && face.propagating(transmitted, 0) &&
                face.propagating(transmitted, 1)) {
                std::array<Wave, 2> waves{face.reflected(0), face.reflected(1)};
                if (transmitted) waves = {face.transmitted(0), face.transmitted(1)};
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    for (std::size_t i = 0; i < 2; ++i) {
                        child.amplitude[axis][i] =
                            outgoing(face, incoming[axis], first, last, transmitted, i);
                    }
                }
                send_twins(child, waves, guide);
            } else if (medium_out.birefringent) {
                for (std::size_t i = 0; i < 2; ++i) {
                    if (!face.propagating(transmitted, i)) continue;
                    if (medium_out.plain()) {
                        child.mode = i == 0 ? Mode::ordinary : Mode::extraordinary;
                        child.k = face.wave_vector(transmitted, i);
                        child.ray = i == 0 ? child.k / medium_out.n_o
                                           : extraordinary_ray(medium_out, child.k);
                        child.basis[0] = face.field_direction(transmitted, i);
                    } else {
                        const Wave wave = transmitted ? face.transmitted(i) : face.reflected(i);
                        child.mode = wave.mode;
                        child.k = real(wave.k);
                        child.ray = wave.ray;
                        child.basis = {real(wave.E), imag(wave.E)};
                    }
                    for (std::size_t axis = 0; axis < 2; ++axis) {
                        child.amplitude[axis] = {
                            outgoing(face, incoming[axis], first, last, transmitted, i), 0};
                    }
                    send(child, guide);
                }
            } else if (face.propagating(transmitted, 0)) {
                child.k = face.wave_vector(transmitted, 0);
                child.ray = normalised(child.k);
                child.basis = {face.s_direction(), cross(child.ray, face.s_direction())};
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    for (std::size_t i = 0; i < 2; ++i) {
                        child.amplitude[axis][i] =
                            outgoing(face, incoming[axis], first, last, transmitted, i);
                    }
                }
                send(child, guide);
            }
        }
    }

    static Complex outgoing(const Interface& face, const std::array<Complex, 2>& incoming,
                            std::size_t first, std::size_t last, bool transmitted, std::size_t i) {
        Complex sum = 0;
        for (std::size_t m = first; m <= last; ++m) {
            sum += incoming[m] * face.flux_amplitude(m, transmitted, i);
        }
        return sum;
    }

    /// Both modes of a branch at a facet; false when they do not go on together.
    bool meet_as_one(Branch& fast, Branch& slow, double distance, int facet, Guide& guide) {
        const StoneOptics& within = optics(fast.gem);
        const Stone& stone = world_.scene().gems[static_cast<std::size_t>(fast.gem)].stone;
        const auto face =
            meet_facet(within.medium(), stone.facets[static_cast<std::size_t>(facet)].normal,
                       wave_of(fast, within.medium()), wave_of(slow, within.medium()));
        if (!face) return false;
        ++events_;
        if (needs(fast.gem).absorption) {
            absorb(fast, within, distance, guide);
            absorb(slow, within, distance, guide);
        }
        Branch child = fast;
        child.position = fast.position + distance * fast.ray;
        child.hits = fast.hits + 1;
        child.facet = facet;
        child.from = {fast.gem, -1};
        // The slow mode's phase over the fast one's, where the fast one meets the facet.
        const double k0 = 2e6 * std::numbers::pi / wavelength_nm_;
        const Complex turn = std::polar(1.0, k0 * distance * dot(slow.k - fast.k, fast.ray));
        const auto combine = [&](const std::array<std::array<Complex, 2>, 2>& coefficients) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                for (std::size_t i = 0; i < 2; ++i) {
                    child.amplitude[axis][i] = fast.amplitude[axis][0] * coefficients[0][i] +
                                               turn * slow.amplitude[axis][0] * coefficients[1][i];
                }
            }
        };
        combine(face->reflect);
        send_twins(child, face->reflected, guide);
        if (!face->leaves) return true;
        combine(face->transmit);
        child.gem = -1;
        child.k = face->k;
        child.ray = normalised(child.k);
        child.basis = face->basis;
        send(child, guide);
        return true;
    }

    static Wave wave_of(const Branch& b, const Medium& medium) {
        Wave w;
        w.mode = b.mode;
        w.k = complexified(b.k);
        w.E = complexified(b.basis[0]) + Complex(0, 1) * complexified(b.basis[1]);
        w.H = medium.magnetic_field(w.k, w.E);
        w.n_phase = length(b.k);
        return w;
    }

    /// Two modes that leave one event, the amplitudes in the two columns.
    void send_twins(Branch& child, const std::array<Wave, 2>& waves, Guide& guide) {
        child.mode = waves[0].mode;
        child.k = real(waves[0].k);
        child.ray = waves[0].ray;
        child.basis = {real(waves[0].E), imag(waves[0].E)};
        child.twin = static_cast<int>(twins_.size());
        twins_.push_back({real(waves[1].k), waves[1].ray, {real(waves[1].E), imag(waves[1].E)}});
        send(child, guide);
        child.twin = -1;
    }

    void send(Branch& child, Guide& guide) {
        child.weight = child.power() * (child.diffused ? child.response.s0 : 1);
        push(child, guide);
    }

    /// What the sensor sees of light whose Stokes vector refers to x right, y towards `up`.
    static Stokes seen_of(const Branch& b, const Stokes& light, const Vec3& up) {
        if (light.s1 == 0 && light.s2 == 0 && light.s3 == 0) return light.s0 * b.unpolarised();
        const Vec3 y = up_across(b.ray, up);
        return b.polarised(light, cross(b.ray, y), y);
    }

    void see_environment(const Branch& b, Guide& guide) {
        sky_light(
            world_.scene().environment, palette_, b.ray,
            [&](const Stokes& light, const Vec3& up) { return seen_of(b, light, up); },
            [&](const Emitter& light, const Stokes& seen) {
                guide.see(light, seen, b.one_wavelength);
            });
    }

    void meet_sheet(const Branch& b, const Vec3& point, const Hit& hit, Guide& guide) {
        const Thing& sheet = world_.scene().things[static_cast<std::size_t>(hit.thing)];
        Branch child = b;
        child.position = point;
        child.from = {-1, hit.thing};
        if (pass_filter(child, *sheet.filter, hit.normal, wavelength_nm_)) send(child, guide);
    }

    /// How much natural light comes to a surface's point from this far: sheets let some through.
    double arriving(Ray ray, Departure from, double distance) {
        std::optional<Branch> probe;
        for (Hit hit; world_.nearest(ray, from, hit) && hit.distance < distance * (1 - 1e-12);) {
            if (hit.thing < 0) return 0;
            const Thing& thing = world_.scene().things[static_cast<std::size_t>(hit.thing)];
            if (!thing.filter) return 0;
            if (!probe) {
                probe = Branch::from_sensor(ray.origin, ray.direction,
                                            any_perpendicular(ray.direction));
            }
            if (!pass_filter(*probe, *thing.filter, hit.normal, wavelength_nm_)) return 0;
            ray.origin += hit.distance * ray.direction;
            distance -= hit.distance;
            from = {-1, hit.thing};
        }
        return probe ? probe->power() : 1;
    }

    void meet_thing(const Branch& b, const Vec3& point, const Hit& hit, Guide& guide) {
        const Scene& scene = world_.scene();
        const auto index = static_cast<std::size_t>(hit.thing);
        const Thing& thing = scene.things[index];
        const Mix mix = mix_at(thing.pigment, point, hit.normal);
        const auto parts = static_cast<std::size_t>(mix.count);
        const Stokes seen = b.unpolarised();
        if (thing.finish.emission != 0) {
            for (std::size_t i = 0; i < parts; ++i) {
                guide.see(palette_.things[index][mix.colour[i]],
                          mix.share[i] * thing.finish.emission * seen, b.one_wavelength);
            }
        }
        if (thing.finish.diffuse == 0) return;
        // No surface sends on more light than falls on it: beyond that, rooms would shine without
        // end.
        double reflectance = 0;
        for (std::size_t i = 0; i < parts; ++i) {
            reflectance += mix.share[i] * thing.pigment.colours[mix.colour[i]](wavelength_nm_);
        }
        const double albedo = std::min(1.0, thing.finish.diffuse * reflectance);
        if (albedo == 0) return;
        const Departure here{-1, hit.thing, hit.triangle};
        for (const Light& light : scene.lights) {
            const auto [u, v] = guide.light_point();
            const LampRay lamp = lamp_ray(light, point, u, v);
            const double cosine = dot(lamp.to_lamp, hit.normal);
            if (!(cosine > 0) || !(lamp.strength > 0)) continue;
            const double arrives =
                light.shadowless ? 1 : arriving({point, lamp.to_lamp}, here, lamp.distance);
            if (arrives == 0) continue;
            guide.see_at_wavelength(
                albedo * cosine * lamp.strength * arrives * light.light(wavelength_nm_), seen);
        }
        const BrightSky& bright = world_.bright_sky();
        const double to_bright = bright.empty() ? 0 : 0.5;
        int rays = guide.diffuse_rays(b);
        if (rays == 1 && to_bright > 0 && !b.diffused) rays = 2;  // one of each kind
        if (rays == 0) return guide.lose(albedo * seen);
        for (int i = 0; i < rays; ++i) {
            const auto [u, v] = guide.diffuse_point(i, rays);
            const Vec3 out =
                u < to_bright ? bright.direction(u / to_bright, v)
                              : cosine_direction(hit.normal, (u - to_bright) / (1 - to_bright), v);
            // Lambert's cosine over the mixed density of both kinds of rays (Veach and Guibas 1995,
            // balance heuristic).
            const double lambert = dot(out, hit.normal) / std::numbers::pi;
            if (!(lambert > 0)) continue;
            const double density =
                (1 - to_bright) * lambert + (to_bright > 0 ? to_bright * bright.density(out) : 0);
            Branch child = Branch::from_sensor(point, out, any_perpendicular(out));
            child.from = here;
            child.diffused = child.one_wavelength = true;
            child.response = (albedo / rays * lambert / density) * seen;
            child.hits = b.hits;
            child.bounces = b.bounces + 1;
            child.weight = albedo / rays * seen.s0;  // of what it may find, lamps counted
            push(child, guide);
        }
    }

    const World& world_;
    const Palette& palette_;
    std::vector<StoneNeeds> needs_;
    bool heaviest_first_;
    Medium air_ = Medium::isotropic(1);
    double wavelength_nm_ = 0;
    std::vector<StoneOptics> stones_;
    std::vector<Branch> branches_;
    std::vector<Twin> twins_;
    std::uint64_t events_ = 0;
};

}  // namespace icespar
