// Columns of numbers read into lanes and written from them.
#pragma once

#include "interface/batch.hpp"
#include "interface/lane_face.hpp"

namespace icespar::lanes {

/// The faces first .. first + count - 1, count at most the number of lanes; lanes beyond repeat the
/// last face.
template <class V>
struct Group {
    std::size_t first, count;

    [[nodiscard]] bool full() const { return count == V::size(); }
    [[nodiscard]] std::size_t face(std::size_t lane) const {
        return first + (lane < count ? lane : count - 1);
    }

    [[nodiscard]] V load(const Column& column) const {
        if (column.stride == 0) return number<V>(*column.data);
        if (column.stride == 1 && full()) {
            return V(column.data + first, std::experimental::element_aligned);
        }
        double lanes[V::size()];
        for (std::size_t lane = 0; lane < V::size(); ++lane) {
            lanes[lane] = column.data[static_cast<std::ptrdiff_t>(face(lane)) * column.stride];
        }
        return V(lanes, std::experimental::element_aligned);
    }
    [[nodiscard]] Vector3<V> load(const VectorColumn& column) const {
        return {load(column.x), load(column.y), load(column.z)};
    }
    [[nodiscard]] MediumLanes<V> load(const MediumColumn& column) const {
        if (column.stride == 0) {
            const Medium& m = *column.data;
            return {number<V>(m.n_o),
                    number<V>(m.n_e),
                    {number<V>(m.axis.x), number<V>(m.axis.y), number<V>(m.axis.z)}};
        }
        const auto each = [&](auto part) {
            return V([&](auto lane) {
                return static_cast<typename V::value_type>(
                    part(column.data[static_cast<std::ptrdiff_t>(face(lane)) * column.stride]));
            });
        };
        return {each([](const Medium& m) { return m.n_o; }),
                each([](const Medium& m) { return m.n_e; }),
                {each([](const Medium& m) { return m.axis.x; }),
                 each([](const Medium& m) { return m.axis.y; }),
                 each([](const Medium& m) { return m.axis.z; })}};
    }

    [[gnu::always_inline]] void store(const ResultColumn& column, const V& v) const {
        if (!column.data) return;
        if (column.stride == 1 && full()) {
            v.copy_to(column.data + first, std::experimental::element_aligned);
            return;
        }
        double* at = column.data + static_cast<std::ptrdiff_t>(first) * column.stride;
        for (std::size_t lane = 0; lane < count; ++lane, at += column.stride) *at = v[lane];
    }
    void store(const VectorResult& column, const Vector3<V>& v) const {
        store(column.x, v.x);
        store(column.y, v.y);
        store(column.z, v.z);
    }
    template <class T>
    void store(const ComplexResult& column, const Vector3<T>& v) const {
        store(column.real, real_part(v));
        store(column.imag, imag_part(v));
    }
    void store(bool* to, std::ptrdiff_t stride, const Mask<V>& v) const {
        if (!to) return;
        for (std::size_t lane = 0; lane < count; ++lane) {
            to[static_cast<std::ptrdiff_t>(first + lane) * stride] = v[lane];
        }
    }
};

}  // namespace icespar::lanes
