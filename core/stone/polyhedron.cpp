// Facet planes or points become a polyhedron, in exact arithmetic: the only file that includes
// CGAL.
#include "stone/polyhedron.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "math/error.hpp"

namespace icespar {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Loop = std::vector<std::uint32_t>;

/// Facets whose area is below this times their longest diagonal times the stone's size are slivers.
constexpr double narrowest_facet = 1e-7;

/// normal . p <= distance, with a distance greater than 0: the origin is inside.
struct ExactPlane {
    Vector normal;
    Number distance;
};

double rounded(const Number& x) { return CGAL::to_double(CGAL::exact(x)); }

Vec3 rounded(const Vector& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

Vector exact(const Vec3& v) { return {v.x, v.y, v.z}; }

Vector from_origin(const Point& p) { return p - CGAL::ORIGIN; }

/// Numbers of four points that span space, or of as many fewer as there are.
std::vector<std::size_t> spanning_points(const std::vector<Point>& p) {
    std::vector<std::size_t> basis;
    const auto at = [&](std::size_t k) -> const Point& { return p[basis[k]]; };
    for (std::size_t i = 0; i < p.size() && basis.size() < 4; ++i) {
        const bool independent = basis.empty() || (basis.size() == 1 && p[i] != at(0)) ||
                                 (basis.size() == 2 && !CGAL::collinear(at(0), at(1), p[i])) ||
                                 (basis.size() == 3 && !CGAL::coplanar(at(0), at(1), at(2), p[i]));
        if (independent) basis.push_back(i);
    }
    return basis;
}

/// A triangle of a convex hull, and its plane with the normal outward.
struct HullFace {
    Vector normal;
    Number offset;
    Triangle corners{};
};

/// The convex hull of points that span space; `around` holds the faces about each corner,
/// counter-clockwise from outside, and nothing for points that are no corner.
struct Hull {
    std::vector<HullFace> faces;
    std::vector<std::vector<std::size_t>> around;
};

Hull convex_hull(const std::vector<Point>& points) {
    Mesh mesh;
    CGAL::convex_hull_3(points.begin(), points.end(), mesh);
    std::map<Point, std::uint32_t> number_of;
    for (std::uint32_t i = 0; i < points.size(); ++i) number_of.emplace(points[i], i);

    Hull hull;
    for (const auto f : mesh.faces()) {
        HullFace& face = hull.faces.emplace_back();
        auto h = mesh.halfedge(f);
        for (std::uint32_t& corner : face.corners) {
            corner = number_of.at(mesh.point(mesh.target(h)));
            h = mesh.next(h);
        }
        const auto& [a, b, c] = face.corners;
        face.normal = CGAL::cross_product(points[b] - points[a], points[c] - points[a]);
        face.offset = face.normal * from_origin(points[a]);
    }
    hull.around.resize(points.size());
    for (const auto v : mesh.vertices()) {
        auto& around = hull.around[number_of.at(mesh.point(v))];
        const auto first = mesh.halfedge(v);
        auto h = first;
        do {
            around.push_back(mesh.face(h));
            h = mesh.prev(mesh.opposite(h));
        } while (h != first);
    }
    return hull;
}

/// loops[i] is empty, and areas[i] 0, for a plane that does not touch the polyhedron in a facet.
struct Polyhedron {
    std::vector<Point> vertices;
    std::vector<Loop> loops;
    std::vector<double> areas;
    double volume = 0;
    std::vector<Vec3> open;
};

/// Edges from a facet's first corner are exact and rounded once. The triangles of its fan all look
/// the same way, and the origin is inside: nothing cancels.
void measure(Polyhedron& p) {
    for (const Loop& loop : p.loops) {
        double area = 0, height = 0;
        const auto edge = [&](std::size_t k) {
            return rounded(p.vertices[loop[k]] - p.vertices[loop[0]]);
        };
        if (!loop.empty()) {
            const Vec3 first = rounded(from_origin(p.vertices[loop[0]]));
            Vec3 last = edge(1);
            for (std::size_t k = 2; k < loop.size(); ++k) {
                const Vec3 next = edge(k), twice = cross(last, next);
                area += length(twice);
                height += dot(first, twice);
                last = next;
            }
        }
        p.areas.push_back(area / 2);
        p.volume += height;
    }
    p.volume /= 6;
}

/// Directions open to half-spaces whose dual points do not even span space.
std::vector<Vec3> open_directions(const std::vector<Point>& dual,
                                  const std::vector<std::size_t>& basis) {
    const Vector q = from_origin(dual[basis[0]]);
    if (basis.size() == 3) {
        const Vector m = CGAL::normal(dual[basis[0]], dual[basis[1]], dual[basis[2]]);
        const auto side = CGAL::sign(m * q);
        if (side != CGAL::ZERO) return {rounded(side == CGAL::POSITIVE ? -m : m)};
        return {rounded(m), rounded(-m)};
    }
    Vector m = CGAL::NULL_VECTOR;
    if (basis.size() == 2) m = CGAL::cross_product(q, from_origin(dual[basis[1]]));
    for (const Vector& axis : {Vector(1, 0, 0), Vector(0, 1, 0)}) {
        if (m == CGAL::NULL_VECTOR) m = CGAL::cross_product(q, axis);
    }
    return {rounded(m), rounded(-m)};
}

/// By polar duality: the convex hull of the points normal / distance has a vertex for each facet
/// and a face for each vertex. Planes that are not `used` are as if absent.
Polyhedron polyhedron(const std::vector<ExactPlane>& planes, const std::vector<bool>& used) {
    std::vector<Point> dual;
    std::vector<std::size_t> plane_of;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (!used[i]) continue;
        dual.push_back(CGAL::ORIGIN + planes[i].normal / planes[i].distance);
        plane_of.push_back(i);
    }
    Polyhedron out;
    const auto basis = spanning_points(dual);
    if (basis.size() < 4) {
        out.open = open_directions(dual, basis);
        return out;
    }
    const Hull hull = convex_hull(dual);
    std::vector<Point> corner_of_face;
    for (const HullFace& face : hull.faces) {
        if (face.offset <= 0) {
            out.open.push_back(rounded(face.normal));
        } else {
            corner_of_face.push_back(CGAL::ORIGIN + face.normal / face.offset);
        }
    }
    if (!out.open.empty()) return out;

    // Faces of the hull that lie in one plane are the same vertex. Vertices are numbered by first
    // use and loops begin at their least corner, whatever order the hull came in.
    out.loops.resize(planes.size());
    std::map<Point, std::uint32_t> number_of;
    for (std::size_t d = 0; d < dual.size(); ++d) {
        std::vector<Point> loop;
        for (const std::size_t face : hull.around[d]) {
            const Point& corner = corner_of_face[face];
            if (loop.empty() || loop.back() != corner) loop.push_back(corner);
        }
        while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
        if (loop.size() < 3) continue;
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        for (const Point& corner : loop) {
            const auto [place, is_new] =
                number_of.emplace(corner, static_cast<std::uint32_t>(out.vertices.size()));
            if (is_new) out.vertices.push_back(corner);
            out.loops[plane_of[d]].push_back(place->second);
        }
    }
    measure(out);
    return out;
}

/// Which planes have a facet wider than rounding.
std::vector<bool> wide_facets(const Polyhedron& p) {
    std::vector<Vec3> corners;
    double size = 0;
    for (const Point& v : p.vertices) {
        corners.push_back(rounded(from_origin(v)));
        size = std::max(size, 2 * length(corners.back()));
    }
    std::vector<bool> wide;
    for (std::size_t i = 0; i < p.loops.size(); ++i) {
        const Loop& loop = p.loops[i];
        double diagonal = 0;
        for (const std::uint32_t a : loop) {
            for (const std::uint32_t b : loop) {
                diagonal = std::max(diagonal, length(corners[a] - corners[b]));
            }
        }
        wide.push_back(!loop.empty() && p.areas[i] >= narrowest_facet * diagonal * size);
    }
    return wide;
}

/// The polyhedron of the planes that have more than a sliver of it. A narrow facet that cuts off
/// more than a millionth of the volume (the blunt end of a needle) stays.
Polyhedron without_slivers(const std::vector<ExactPlane>& planes) {
    Polyhedron p = polyhedron(planes, std::vector<bool>(planes.size(), true));
    while (p.open.empty()) {
        const std::vector<bool> wide = wide_facets(p);
        const bool same = std::equal(wide.begin(), wide.end(), p.loops.begin(),
                                     [](bool w, const Loop& loop) { return w == !loop.empty(); });
        if (same || std::count(wide.begin(), wide.end(), true) < 4) break;
        Polyhedron next = polyhedron(planes, wide);
        if (!next.open.empty() || next.volume > p.volume * (1 + 1e-6)) break;
        p = std::move(next);
    }
    return p;
}

/// The polyhedron in double precision, its origin moved to `centre`.
Stone stone_of(const Polyhedron& p, const std::vector<ExactPlane>& planes, const Vector& centre) {
    Stone stone;
    for (const Point& v : p.vertices) stone.vertices.push_back(rounded(from_origin(v) + centre));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (p.loops[i].empty()) continue;
        const Vector& n = planes[i].normal;
        const Number largest = (std::max)(
            {Number(CGAL::abs(n.x())), Number(CGAL::abs(n.y())), Number(CGAL::abs(n.z()))});
        const Vec3 direction = rounded(n / largest);
        const double distance = rounded((planes[i].distance + n * centre) / largest);
        stone.facets.push_back(
            {normalised(direction), distance / length(direction), {}, p.loops[i], p.areas[i]});
    }
    stone.volume = p.volume;
    return stone;
}

/// A half-space with `centre` as the origin.
ExactPlane about(const Vector& centre, const HalfSpace& half_space) {
    const auto& through = half_space.through;
    if (!through) {
        const Vector n = exact(half_space.normal);
        return {n, half_space.distance - n * centre};
    }
    const Vector a = exact((*through)[0]) - centre;
    const Vector n =
        CGAL::cross_product(exact((*through)[1]) - centre - a, exact((*through)[2]) - centre - a);
    return {n, n * a};
}

}  // namespace

InnerBall inner_ball(std::span<const HalfSpace> planes) {
    // Unknowns: the centre and the radius r. Maximise r under normal . p + |normal| r <= distance.
    // The solver is exact on doubles; Bland's rule cannot cycle on the symmetric designs of
    // cutters.
    CGAL::Quadratic_program<double> program(CGAL::SMALLER, false, 0, false, 0);
    double farthest = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const int row = static_cast<int>(i);
        const Vec3& n = planes[i].normal;
        const double norm = std::hypot(n.x, n.y, n.z);
        program.set_a(0, row, n.x);
        program.set_a(1, row, n.y);
        program.set_a(2, row, n.z);
        program.set_a(3, row, norm);
        program.set_b(row, planes[i].distance);
        farthest = std::max(farthest, std::abs(planes[i].distance) / norm);
    }
    program.set_u(3, true, farthest > 0 ? farthest : 1);
    program.set_c(3, -1);
    CGAL::Quadratic_program_options options;
    options.set_pricing_strategy(CGAL::QP_BLAND);
    const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpzf(), options);

    InnerBall ball;
    auto value = solution.variable_values_begin();
    ball.centre.x = CGAL::to_double(*value++);
    ball.centre.y = CGAL::to_double(*value++);
    ball.centre.z = CGAL::to_double(*value++);
    ball.radius = CGAL::to_double(*value);
    auto multiplier = solution.optimality_certificate_begin();
    for (std::size_t i = 0; i < planes.size(); ++i, ++multiplier) {
        if (!CGAL::is_zero(*multiplier)) ball.touching.push_back(i);
    }
    return ball;
}

Intersection intersection(std::span<const HalfSpace> planes, const Vec3& centre) {
    std::vector<ExactPlane> about_centre;
    for (const HalfSpace& plane : planes) {
        about_centre.push_back(about(exact(centre), plane));
        if (about_centre.back().distance <= 0) {
            throw Error(
                "the stone is thinner than numbers can tell this far from the origin: make it "
                "thicker, or build it at the origin and move it afterwards");
        }
    }
    const Polyhedron p = without_slivers(about_centre);
    Intersection out{{}, {}, p.open};
    if (!p.open.empty()) return out;
    out.stone = stone_of(p, about_centre, exact(centre));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (p.loops[i].empty()) out.unreached.push_back(i);
    }
    return out;
}

std::vector<Triangle> hull_triangles(std::span<const Vec3> points) {
    std::vector<Point> exact_points;
    for (const Vec3& p : points) exact_points.push_back(CGAL::ORIGIN + exact(p));
    std::vector<Triangle> triangles;
    if (spanning_points(exact_points).size() < 4) return triangles;
    Hull hull = convex_hull(exact_points);
    for (HullFace& face : hull.faces) {
        auto& c = face.corners;
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        triangles.push_back(c);
    }
    // CGAL's order can depend on where memory lies.
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace icespar
