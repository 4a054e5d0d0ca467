// Splines pass through their points, and between them as POV-Ray's do (its own numbers).
#include <catch2/catch.hpp>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinAbs;

namespace {

const std::string points = " 0, <1,0,0>, 1, <2,3,-1>, 2.5, <0,1,4>, 4, <-3,2,2>, 5, <1,1,1> }";

void check(const std::string& kind, const std::string& t, const Vec3& expected) {
    const Vec3 v = vector_of("S(" + t + ")", "#declare S = spline { " + kind + points);
    CAPTURE(kind, t);
    CHECK_THAT(v.x, WithinAbs(expected.x, 1e-6));
    CHECK_THAT(v.y, WithinAbs(expected.y, 1e-6));
    CHECK_THAT(v.z, WithinAbs(expected.z, 1e-6));
}

}  // namespace

TEST_CASE("splines have POV-Ray's values", "[parser][spline]") {
    check("", "0.5", {1.5, 1.5, -0.5});
    check("linear_spline", "1.8", {0.933333, 1.933333, 1.666667});
    check("linear_spline", "-1", {1, 0, 0});
    check("linear_spline", "9", {1, 1, 1});
    check("quadratic_spline", "0.4", {1.624, 1.616, -0.816});
    check("quadratic_spline", "3.2", {-1.275556, 1.093333, 3.937778});
    check("cubic_spline", "0.4", {2, 3, -1});
    check("cubic_spline", "1.8", {1.202963, 2.111704, 1.753778});
    check("cubic_spline", "3.9", {-3.059259, 1.999704, 2.133333});
    check("cubic_spline", "4.6", {-3, 2, 2});
    check("natural_spline", "0.4", {1.521882, 1.566306, -0.811106});
    check("natural_spline", "3.2", {-2.173508, 1.284246, 3.740228});
    check("natural_spline", "4.6", {-1.038118, 1.587106, 1.257694});
    for (const std::string kind : {"linear", "quadratic", "natural"}) {
        check(kind + "_spline", "2.5", {0, 1, 4});
    }
    CHECK_THAT(number_of("S(0.25)", "#declare S = spline { 0, 5, 1, 9 }"), WithinAbs(6, 1e-12));
}

TEST_CASE("a spline with too few values, or two in one place, is a fault", "[parser][spline]") {
    CHECK(faulty("#declare S = spline { cubic_spline 0, 1, 1, 2 }", "needs 4 values at least"));
    CHECK(faulty("#declare S = spline { 0, 1, 0, 2 }", "two values in one place"));
    CHECK(faulty("#declare S = spline { 0, 1, 1, <1, 2> }", "of one size"));
}
