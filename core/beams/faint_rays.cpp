// Lanes are filled anew as rays end; a face that lanes cannot solve is one for InnerFace.
#include "beams/faint_rays.hpp"

#include <algorithm>
#include <limits>

#include "beams/carry.hpp"
#include "beams/roulette.hpp"
#include "interface/inner_face.hpp"

namespace icespar {
namespace {

void put(const Vec3& v, RayLanes::Row* rows, int lane) {
    rows[0][lane] = v.x;
    rows[1][lane] = v.y;
    rows[2][lane] = v.z;
}
Vec3 get(const RayLanes::Row* rows, int lane) {
    return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

}  // namespace

FaintRays::FaintRays(const FacetSearch& facets)
    : air_(Medium::isotropic(1)), crystal_(air_), facets_(facets) {
    const FacetSearch::Planes& p = facets.planes();
    stone_.x = p.x.data();
    stone_.y = p.y.data();
    stone_.z = p.z.data();
    stone_.distance = p.distance.data();
    stone_.planes = (facets.facets() + 1) / 2 * 2;
}

void FaintRays::set_medium(const Medium& crystal, bool spectral, double dn_o, double dn_e) {
    crystal_ = crystal;
    surface_ = IndexSurface(crystal, dn_o, dn_e);
    stone_.eps_o = surface_.eps_o;
    stone_.eps_e = surface_.eps_e;
    stone_.swell_o = surface_.swell_o;
    stone_.swell_e = surface_.swell_e;
    stone_.spectral = spectral;
    stone_.axis[0] = crystal.axis.x;
    stone_.axis[1] = crystal.axis.y;
    stone_.axis[2] = crystal.axis.z;
}

void FaintRays::start(int lane, const Ray& ray) {
    rays_[static_cast<std::size_t>(lane)] = ray;
    put(ray.position, lanes_.position, lane);
    put(ray.k, lanes_.k, lane);
    put(ray.field, lanes_.field, lane);
    put(ray.fan, lanes_.fan, lane);
    lanes_.extraordinary[lane] = ray.extraordinary ? 1 : 0;
    lanes_.left[lane] = ray.left;
    lanes_.weight[lane] = ray.weight;
}

bool FaintRays::meet(int lane) {
    const Vec3 normal = facets_.normal(static_cast<int>(lanes_.left[lane]));
    const double weight = lanes_.weight[lane];
    const InnerFace face(crystal_, air_, normal, get(lanes_.k, lane), get(lanes_.field, lane),
                         lanes_.extraordinary[lane] != 0);
    lanes_.passed[lane] =
        face.passes ? weight * (std::norm(face.out_s) + std::norm(face.out_p)) : 0;
    put(face.k_out, lanes_.out, lane);
    // Both in phase, or in opposite phase.
    const double size = std::abs(face.out_s);
    lanes_.out_s[lane] = size;
    lanes_.out_p[lane] =
        size > 0 ? (face.out_p * std::conj(face.out_s)).real() / size : std::abs(face.out_p);
    const Vec3 fan = get(lanes_.fan, lane);
    if (stone_.spectral && face.passes) {
        put(fanned(fan, normal, face.k_out, 0), lanes_.out_fan, lane);
    }
    const auto power = [&](std::size_t i) {
        return face.reflected.propagates[i] ? weight * std::norm(face.amplitude[i]) : 0;
    };
    const double e = power(1), stays = power(0) + e;
    const double survival = std::min(stays / threshold_, lanes_.most[lane]);
    if (!(lanes_.chance[lane] < survival)) return false;
    const std::size_t mode = lanes_.chance[lane] * stays < survival * e ? 1 : 0;
    lanes_.weight[lane] = stays / survival;
    lanes_.extraordinary[lane] = mode == 1 ? 1 : 0;
    const Vec3& k = face.reflected.k[mode];
    if (stone_.spectral) {
        const Vec3 flow = surface_.energy(k, mode == 1);
        put(fanned(fan, normal, flow, surface_.swelling(k, mode == 1)), lanes_.fan, lane);
    }
    put(k, lanes_.k, lane);
    put(face.reflected.E[mode], lanes_.field, lane);
    return true;
}

void FaintRays::begin(double threshold, int most_hits, Lanes width) {
    step_ = step_baseline;
#ifdef ICESPAR_AVX512
    if (width == Lanes::avx512) step_ = step_avx512;
#endif
    // Where digits would be lost; by scalars, all.
    stone_.delicate = width == Lanes::scalar ? std::numeric_limits<double>::infinity() : 1e-4;
    threshold_ = threshold;
    most_hits_ = most_hits;
    busy_ = {};
    next_ = 0;
    lost_ = 0;
}

bool FaintRays::step() {
    int active = 0;
    for (int lane = 0; lane < RayLanes::size; ++lane) {
        const auto i = static_cast<std::size_t>(lane);
        if (!busy_[i] && next_ < waiting_.size()) {
            start(lane, waiting_[next_++]);
            busy_[i] = true;
        }
        if (!busy_[i]) continue;
        ++active;
        Ray& ray = rays_[i];
        lanes_.chance[lane] = ray.random.uniform();
        lanes_.most[lane] = ++ray.hits < Roulette::patient || whole_ ? 1 : Roulette::patience;
    }
    if (active == 0) return false;
    events_ += static_cast<std::uint64_t>(active);
    step_(stone_, threshold_, lanes_);
    return true;
}

bool FaintRays::arrive(int lane) {
    const auto i = static_cast<std::size_t>(lane);
    if (lanes_.left[lane] < 0) {
        lost_ += lanes_.weight[lane];
        return busy_[i] = false;
    }
    const bool alive = lanes_.solved[lane] != 0 ? lanes_.alive[lane] != 0 : meet(lane);
    busy_[i] = alive && (most_hits_ == 0 || rays_[i].hits < most_hits_);
    if (alive && !busy_[i]) lost_ += lanes_.weight[lane];
    const bool passes = lanes_.passed[lane] > 0;
    if (!whole_) return passes;
    if (!alive && !passes) lost_ += 1;
    return !alive && passes;
}

FaintRays::Exit FaintRays::exit(int lane) const {
    const Ray& ray = rays_[static_cast<std::size_t>(lane)];
    const Vec3 k = get(lanes_.out, lane);
    return {get(lanes_.position, lane),
            k,
            get(lanes_.out_fan, lane),
            whole_ ? 1 : lanes_.passed[lane],
            cross(facets_.normal(static_cast<int>(lanes_.left[lane])), k),
            lanes_.out_s[lane],
            lanes_.out_p[lane],
            ray.hits,
            ray.owner,
            static_cast<int>(lanes_.left[lane])};
}

}  // namespace icespar
