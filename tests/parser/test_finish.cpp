// Finishes and textures as POV-Ray joins them; the expected values are those of its pictures.
#include <catch2/catch.hpp>

#include "parser/load.hpp"

using namespace icespar;

namespace {

Finish finish_of(const std::string& object) {
    const std::string text =
        "#declare F = finish { diffuse 0.9 ambient 0 }\n"
        "#declare T = texture { pigment { rgb 1 } finish { F } }\n"
        "camera { location -5*z look_at 0 }\n" +
        object;
    const LoadResult result = load_scene_text(text, "finish", ".");
    REQUIRE(result.scene);
    REQUIRE(result.scene->things.size() == 1);
    return result.scene->things[0].finish;
}

}  // namespace

TEST_CASE("a second finish amends the first", "[parser][surface]") {
    const Finish on_object =
        finish_of("sphere { 0, 1 pigment { rgb 1 } finish { F } finish { ambient 0.1 } }");
    CHECK(on_object.diffuse == 0.9);
    CHECK(on_object.emission == Approx(0.1));
    const Finish in_texture = finish_of("sphere { 0, 1 texture { T finish { ambient 0.1 } } }");
    CHECK(in_texture.diffuse == 0.9);
    CHECK(in_texture.emission == Approx(0.1));
}

TEST_CASE("a part with a pigment of its own takes no finish from its union", "[parser][surface]") {
    const Finish own = finish_of("union { sphere { 0, 1 pigment { rgb 1 } } finish { F } }");
    CHECK(own.diffuse == Finish{}.diffuse);
    const Finish shared = finish_of("union { sphere { 0, 1 } pigment { rgb 1 } finish { F } }");
    CHECK(shared.diffuse == 0.9);
}
