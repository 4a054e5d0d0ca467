// Expressions have the values they have in POV-Ray 3.7; the figures were printed by it.
#include <catch2/catch.hpp>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinAbs;

namespace {

void check(const Vec3& v, double x, double y, double z, double tolerance = 1e-12) {
    CHECK_THAT(v.x, WithinAbs(x, tolerance));
    CHECK_THAT(v.y, WithinAbs(y, tolerance));
    CHECK_THAT(v.z, WithinAbs(z, tolerance));
}

}  // namespace

TEST_CASE("products bind more than sums, and a minus belongs to its factor", "[expressions]") {
    CHECK(number_of("2+3*4-6/2") == 11);
    CHECK(number_of("-2*3") == -6);
    CHECK(number_of("2*-3") == -6);
    CHECK(number_of("(2+3)*4") == 20);
    CHECK(number_of("8/4/2") == 1);
    CHECK(number_of("1.5e1 + .5") == 15.5);
}

TEST_CASE("& and | are equals among themselves and come after comparisons", "[expressions]") {
    CHECK(number_of("1 | 0 & 0") == 0);
    CHECK(number_of("(1=1)+(2>1)") == 2);
    CHECK(number_of("1 < 2 & 3 >= 3") == 1);
    CHECK(number_of("2 != 2 | !1") == 0);
    CHECK(number_of("2 > 1 ? 5 : 6") == 5);
    CHECK(number_of("yes + on + true - no - off - false") == 3);
}

TEST_CASE("floats differ only by more than POV-Ray's tolerance", "[expressions]") {
    CHECK(number_of("0.1 + 0.2 = 0.3") == 1);
    CHECK(number_of("1 = 1.0000001") == 0);
}

TEST_CASE("a float beside a vector becomes a vector of its size", "[expressions]") {
    check(vector_of("<1, 2, 3>*2 + 1"), 3, 5, 7);
    check(vector_of("y*30 - x"), -1, 30, 0);
    check(vector_of("4"), 4, 4, 4);
    CHECK(number_of("(<1, 2> + <1, 2, 3, 4>).t") == 4);
    CHECK(number_of("(<1, 2> + <1, 2, 3, 4>).y") == 4);
    check(vector_of("<u.x, v.y, t.t>"), 1, 1, 1);
}

TEST_CASE("functions of floats and vectors agree with POV-Ray's", "[expressions]") {
    CHECK(number_of("mod(-7, 3)") == -1);
    CHECK(number_of("div(-7, 3)") == -2);
    CHECK(number_of("int(-2.5)") == -2);
    CHECK(number_of("ceil(-1.2)") == -1);
    CHECK(number_of("floor(-1.2)") == -2);
    CHECK(number_of("pow(-8, 3)") == -512);
    CHECK_THAT(number_of("atan2(1, -1)"), WithinAbs(2.356194, 5e-7));
    CHECK_THAT(number_of("degrees(pi)"), WithinAbs(180, 1e-12));
    CHECK(number_of("max(1, 5, 3) - min(4, 2)") == 3);
    CHECK(number_of("select(-1, 1, 2, 3)*1000 + select(0, 1, 2, 3)*100 + select(1, 1, 2, 3)*10 + "
                    "select(0, 1, 2)") == 1232);
    check(vector_of("vaxis_rotate(<1, 2, 3>, <0, 1, 1>, 30)"), 1.21957879, 2.42054069, 2.57945931,
          5e-9);
    check(vector_of("vrotate(<1, 2, 3>, <10, 20, 30>)"), 1.06742538, 2.28905948, 2.76058141, 5e-9);
    check(vector_of("vcross(x, y)"), 0, 0, 1);
    check(vector_of("vnormalize(<0, 3, 4>)"), 0, 0.6, 0.8);
    CHECK(number_of("vdot(<1, 2, 3>, <4, 5, 6>) + vlength(<3, 4, 0>)") == 37);
}

TEST_CASE("rand yields POV-Ray's own numbers", "[expressions]") {
    check(vector_of("<rand(D), rand(D), rand(D)>", "#declare D = seed(42);"), 0.7235829112,
          0.3299792596, 0.7557616704, 5e-11);
}

TEST_CASE("strings are cut, joined, compared and turned into numbers", "[expressions]") {
    CHECK(number_of("strlen(concat(\"dia\", \"mond\"))") == 7);
    CHECK(number_of("strcmp(substr(\"diamond\", 2, 3), \"iam\")") == 0);
    CHECK(number_of("strcmp(\"a\", \"b\")") == -1);
    CHECK(number_of("strcmp(strupr(\"aZ\"), \"AZ\") + strcmp(strlwr(\"aZ\"), \"az\")") == 0);
    CHECK(number_of("val(\"2.5\") + asc(\"A\") + strlen(chr(65))") == 68.5);
    CHECK(number_of("strcmp(str(3.14159, 8, 2), \"    3.14\")") == 0);
    CHECK(number_of("strcmp(str(3.14159, -8, 2), \"00003.14\")") == 0);
    CHECK(number_of("strcmp(str(2.5, 0, -1), \"2.500000\")") == 0);
    CHECK(number_of("strcmp(str(-1.5, -7, 1), \"-0001.5\")") == 0);
    CHECK(number_of("strcmp(vstr(3, <1, 2, 3>, \",\", 0, 1), \"1.0,2.0,3.0\")") == 0);
}

TEST_CASE("colours have five components and mean what POV-Ray means by them", "[expressions]") {
    const std::string c =
        "#declare C = rgb <1, 0.5, 0.25>; #declare D = rgbf 0.5; "
        "#declare E = rgbt <1, 0.5, 0.25, 0.1>; #declare F = color red 0.5 filter 0.2; "
        "#declare G = srgb <0.5, 0.02, 1>; #declare H = rgb 1*0.5;";
    check(vector_of("<C.red, C.green, C.blue>", c), 1, 0.5, 0.25);
    check(vector_of("<D.red, D.filter, D.transmit>", c), 0.5, 0.5, 0);
    check(vector_of("<E.blue, E.filter, E.transmit>", c), 0.25, 0, 0.1);
    check(vector_of("<F.red, F.green, F.filter>", c), 0.5, 0, 0.2);
    check(vector_of("<G.red, G.green, G.blue>", c), 0.21404, 0.00155, 1, 5e-6);
    check(vector_of("<H.red, H.filter, (C*2).green>", c), 0.5, 0, 1);
}

TEST_CASE("arrays hold anything, nest, and are copied when they are declared anew",
          "[expressions]") {
    const std::string a =
        "#declare A = array[2][2] {{1, 2}, {3, 4}}; #declare B = A; "
        "#declare B[1][0] = 10; #declare C = array {\"a\", x, rgb 1};";
    CHECK(number_of("A[1][0] + B[1][0]", a) == 13);
    CHECK(number_of("dimensions(A)*10 + dimension_size(A, 2)", a) == 22);
    CHECK(number_of("dimension_size(C, 1) + strlen(C[0]) + C[1].x", a) == 5);
}

TEST_CASE("the picture's size and the clock come from outside", "[expressions]") {
    LoadOptions options;
    options.width = 320;
    options.height = 200;
    options.clock = 0.25;
    const Scene scene = scene_of("camera { location <image_width, image_height, clock> }", options);
    CHECK(scene.camera.location == Vec3{320, 200, -0.25});
}
