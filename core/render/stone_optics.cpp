// Media of stones, and the absorption of their waves.
#include "render/stone_optics.hpp"

#include <cmath>

#include "crystal/loss.hpp"

namespace icespar {
namespace {

Medium medium_of(const Crystal& c, double nm, bool general) {
    const auto& n = c.indices;
    if (n.size() == 1) return Medium::isotropic(n[0](nm));
    if (n.size() == 3) {
        return Medium::biaxial({n[0](nm), n[1](nm), n[2](nm)}, c.axis, cross(c.third_axis, c.axis));
    }
    const double rotation = c.rotation(nm);
    if (rotation == 0 && general) {
        const double n_o = n[0](nm);
        return Medium::biaxial({n[1](nm), n_o, n_o}, c.axis, any_perpendicular(c.axis));
    }
    if (rotation == 0) return Medium::uniaxial(n[0](nm), n[1](nm), c.axis);
    return Medium::active(n[0](nm), n[1](nm), c.axis, rotation, nm);
}

}  // namespace

StoneOptics::StoneOptics(const Crystal& c, double nm, bool general)
    : medium_(medium_of(c, nm, general)), wavelength_nm_(nm), fade_(c.fade ? &*c.fade : nullptr) {
    if (c.absorption.empty()) return;
    const auto strength = [&](std::size_t i) { return c.indices[i](nm) * c.absorption[i](nm); };
    const double first = strength(0);
    if (c.indices.size() == 3) {
        loss_ = first * dyad(c.axis) + strength(1) * dyad(cross(c.third_axis, c.axis)) +
                strength(2) * dyad(c.third_axis);
    } else {
        loss_ = RealTensor::diagonal(first, first, first);
        if (c.indices.size() == 2) loss_ = loss_ + (strength(1) - first) * dyad(c.axis);
    }
}

Absorption StoneOptics::absorption() const {
    return {loss_, fade_ ? (1 - fade_->colour(wavelength_nm_)) / fade_->distance : 0};
}

double StoneOptics::transmittance(const Vec3& k, const Vec3& ray, const Vec3& re, const Vec3& im,
                                  double length) const {
    double loss = medium_.symmetry == Symmetry::isotropic
                      ? loss_.xx / dot(k, ray)
                      : loss_along(loss_, re, k, ray) + loss_along(loss_, im, k, ray);
    if (medium_.active()) {
        // What flows, |E x H|, is not quite k . ray.
        const CVec3 E = complexified(re) + Complex(0, 1) * complexified(im);
        loss *= dot(k, ray) /
                dot(real(cross(E, conj(medium_.magnetic_field(complexified(k), E)))), ray);
    }
    const double left = loss > 0 ? std::exp(-loss * length) : 1;
    return fade_ ? left * fade_->transmittance(length, wavelength_nm_) : left;
}

}  // namespace icespar
