// Directives: what a scene declares, repeats, leaves out and includes.
#include <catch2/catch.hpp>
#include <fstream>

#include "parser/scene_text.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;

namespace {

/// The y of the camera that the text places.
double result_of(const std::string& text) { return scene_of(text).camera.location.y; }

}  // namespace

TEST_CASE("a loop adds up what it counts", "[directives]") {
    CHECK(result_of(
              "#declare S = 0; #for (I, 1, 10) #declare S = S + I; #end camera { location y*S }") ==
          55);
    CHECK(result_of("#declare S = 0; #for (I, 10, 1, -3) #declare S = S + I; #end camera { "
                    "location y*S }") == 22);
    CHECK(result_of("#declare S = 0; #declare I = 0; #while (I < 10) #declare I = I + 1; #if (I = "
                    "5) #break "
                    "#end #declare S = S + I; #end camera { location y*S }") == 10);
    CHECK(result_of("#declare S = 1; #for (I, 0, 1, 0.1) #declare S = S + 1; #end camera { "
                    "location y*S }") == 12);
    CHECK(result_of(
              "#declare S = 1; #for (I, 2, 1) #declare S = 100; #end camera { location y*S }") ==
          1);
}

TEST_CASE("one branch is taken and the others are not read", "[directives]") {
    CHECK(result_of("#if (0) @ nonsense { #elseif (1) camera { location y*2 } #else ! #end") == 2);
    CHECK(
        result_of(
            "#declare A = 1; #ifdef (A) #ifndef (B) camera { location y*3 } #end #else bad #end") ==
        3);
    CHECK(result_of("#undef A #declare A = 2; #undef A #ifdef (A) bad #else camera { location y*4 "
                    "} #end") == 4);
}

TEST_CASE("a case runs on into the next until a break", "[directives]") {
    const std::string choice =
        "#declare S = 0; #switch (N) #case (1) #declare S = S + 1; #case (2) #declare S = S + 2; "
        "#break "
        "#range (3, 5) #declare S = S + 30; #break #else #declare S = 400; #end camera { location "
        "y*S }";
    CHECK(result_of("#declare N = 1;" + choice) == 3);
    CHECK(result_of("#declare N = 2;" + choice) == 2);
    CHECK(result_of("#declare N = 4;" + choice) == 30);
    CHECK(result_of("#declare N = 9;" + choice) == 400);
}

TEST_CASE("directives may stand within an expression", "[directives]") {
    CHECK(result_of("#declare A = 1; camera { location <0, #if (A) 5 #else 6 #end, 0> }") == 5);
    CHECK(result_of("#declare V = #if (1) 7 #else 8 #end; camera { location y*V }") == 7);
    CHECK(result_of("#declare V = <0, 1 #for (I, 1, 3) + I #end, 0>; camera { location V }") == 7);
}

TEST_CASE("a macro may yield half an expression, and has locals of its own", "[directives]") {
    CHECK(result_of("#macro Plus(N) + N #end camera { location y*(2 Plus(3)) }") == 5);
    CHECK(result_of("#declare K = 1; #macro F(X) #local K = X*2; K + 1 #end camera { location "
                    "y*(F(4)*K) }") == 9);
    CHECK(
        result_of(
            "#macro F(X) #if (X > 1) (X*F(X - 1)) #else 1 #end #end camera { location y*F(5) }") ==
        120);
    CHECK(result_of(
              "#macro F(X) #local R = X*2; R #end #declare A = F(3); camera { location y*A }") ==
          6);
}

TEST_CASE("a name handed to a macro can be declared there", "[directives]") {
    CHECK(result_of(
              "#macro Set(A, V) #declare A = V; #end Set(Found, 8) camera { location y*Found }") ==
          8);
    CHECK(result_of("#declare N = 1; #macro Add(A) #declare A = A + 1; #end Add(N) Add(N) camera { "
                    "location y*N }") == 3);
}

TEST_CASE("objects, textures and transforms can be declared and used", "[directives]") {
    const Scene scene = scene_of(
        "#declare T = transform { translate x scale 2 } #declare P = pigment { rgb 1 } "
        "#declare Ball = sphere { 0, 1 pigment { P } } object { Ball transform { T } } object { "
        "Ball transform T "
        "translate y }");
    REQUIRE(scene.things.size() == 2);
    CHECK(scene.things[0].to_world.point({0, 0, 0}) == Vec3{2, 0, 0});
    CHECK(scene.things[1].to_world.point({0, 0, 0}) == Vec3{2, 1, 0});
}

TEST_CASE("our own words may be names where they mean nothing", "[directives]") {
    CHECK(result_of("#declare index = 2; #declare line = 3; #local gear = 1; camera { location "
                    "y*(index + line + gear) }") == 6);
}

TEST_CASE("an include is found beside its file, and locals stay in it", "[directives][files]") {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "parts");
    std::ofstream(folder / "parts/a.inc") << "#include \"b.inc\"\n#local Hidden = 1;\n";
    std::ofstream(folder / "parts/b.inc") << "#declare Height = 5;\n";
    std::ofstream(folder / "main.spar")
        << "// Shows an include\n#include \"parts/a.inc\"\n"
           "#ifdef (Hidden) #error \"seen\" #end\ncamera { location y*Height }\n";
    const LoadResult result = load_scene_file(folder / "main.spar");
    INFO(messages(result));
    REQUIRE(result.scene);
    CHECK(result.scene->camera.location.y == 5);
    CHECK(result.scene->title == "Shows an include");
}

TEST_CASE("files out of bounds stay unread, also behind a link", "[directives][files]") {
    const ScratchFolder folder, other;
    std::ofstream(other / "secret.inc") << "#declare Secret = 1;\n";
    std::filesystem::create_symlink(other / "secret.inc", folder / "link.inc");
    const auto load = [&](const std::string& name, const LoadOptions& options) {
        return load_scene_text("#include \"" + name + "\"", "s.spar", folder / "", options);
    };
    CHECK_FALSE(load(other / "secret.inc", {}).scene);
    CHECK_FALSE(load("link.inc", {}).scene);
    CHECK_FALSE(load("../" + std::filesystem::path(other / "").parent_path().filename().string() +
                         "/secret.inc",
                     {})
                    .scene);
    LoadOptions allowed;
    allowed.allow = {other / ""};
    CHECK(load(other / "secret.inc", allowed).scene);
    CHECK(load("link.inc", allowed).scene);
    CHECK(load("secret.inc", allowed).scene);
}

TEST_CASE("whether a file outside exists cannot be asked", "[directives][files]") {
    CHECK(number_of("file_exists(\"/etc/passwd\") + file_exists(\"shapes.inc\")*10") == 10);
}
