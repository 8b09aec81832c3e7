#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/sparse_system.h>
#include <hachure/runtime/geometry/stripe_rate.h>
#include <hachure/tests/runtime/geometry/line_reference.h>
#include <hachure/tests/runtime/geometry/striped.h>

#include <filesystem>
#include <numbers>
#include <random>

namespace hachure::geometry {
namespace {

/// The field on a mesh, with what it is made of.
struct Field {
    SurfaceSheets sheets;
    SheetMetric metric;
    std::vector<std::uint32_t> order;
    SheetCurvature curvature;
    DirectionField field;

    Field(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices, double detail = 0.1)
        : sheets(cut_into_sheets(positions, {}, indices, 4.0)), metric(sheets),
          order(elimination_order(sheets.positions.size(), sheet_edges(sheets))),
          curvature(sheet_curvature(sheets, metric, order, detail)),
          field(direction_field(sheets, metric, curvature, order, detail)) {}

    [[nodiscard]] int half_turns() const {
        int sum = 0;
        for (const std::int8_t turns : field.half_turns) sum += turns;
        return sum;
    }
};

TEST(DirectionField, SingularitiesAddUpToTheEulerCharacteristic) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(-0.02f, 0.02f);
    for (const double detail : {0.02, 0.1}) {
        Shape ball = icosphere(1.0, 3), ring = irregular_torus(1.0, 0.4, 40, 16, 0.3, 1);
        for (Shape* shape : {&ball, &ring})
            for (glm::vec3& p : shape->positions) p += glm::vec3(noise(random), noise(random), noise(random));
        EXPECT_EQ(Field(ball.positions, ball.indices, detail).half_turns(), 4);
        EXPECT_EQ(Field(ring.positions, ring.indices, detail).half_turns(), 0);
    }
    // Two balls at once.
    Shape two = icosphere(1.0, 2);
    const Shape one = two;
    for (const glm::vec3& p : one.positions) two.positions.push_back(p + glm::vec3(5.0f, 0.0f, 0.0f));
    for (const std::uint32_t i : one.indices)
        two.indices.push_back(i + static_cast<std::uint32_t>(one.positions.size()));
    const Field field(two.positions, two.indices);
    EXPECT_EQ(field.sheets.sheets, 2u);
    EXPECT_EQ(field.half_turns(), 8);
}

TEST(DirectionField, CurvatureOfACylinderIsSmoothedToItself) {
    const Shape shape = torus(1.0, 0.25, 96, 32);
    const Field field(shape.positions, shape.indices, 0.05);
    for (std::uint32_t v = 0; v < field.sheets.positions.size(); ++v)
        EXPECT_NEAR(field.curvature.largest(v), 4.0, 0.15);
}

TEST(DirectionField, ConfidenceTellsDirectionsFromNoise) {
    EXPECT_EQ(direction_confidence(1.0, 0.0, 0.0), 0.0);  // a sphere
    EXPECT_EQ(direction_confidence(0.0, 1.0, 0.0), 0.0);  // a saddle with two equal directions
    EXPECT_EQ(direction_confidence(1.0, 1.0, 0.0), 1.0);  // a cylinder
    EXPECT_EQ(direction_confidence(0.0, 0.0, 0.0), 0.0);  // a plane
    EXPECT_EQ(direction_confidence(1.0, 0.03, 0.0), 0.0); // a sphere with some noise
    EXPECT_LT(direction_confidence(0.01, 0.01, 1.0), 0.1);
}

/// The given bunny as one connected surface, cut along no edge.
struct Bunny {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices;
};

bool read_bunny(Bunny& bunny) {
    const std::filesystem::path file = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(file)) return false;
    const assets::Model model = assets::read_model(file);
    const assets::Primitive& primitive = model.meshes.at(0).primitives.at(0);
    bunny = {primitive.positions, primitive.normals, primitive.indices};
    return true;
}

/// The part of the area on which u grows by less than a quarter of its rate there.
double collapsed(const Striped& striped, const Bunny& bunny, const StripeSettings& settings) {
    const Field f(bunny.positions, bunny.indices, settings.detail);
    const std::vector<double> rates = stripe_rates(f.sheets, f.metric, f.curvature, f.field, f.order, settings.sets);
    double low = 0.0, all = 0.0;
    for (std::size_t t = 0; t < f.sheets.triangles.size(); ++t) {
        const std::uint32_t* corner = &striped.mesh.indices[3 * std::size_t{f.sheets.face[t]}];
        const glm::dvec3 p[3] = {striped.positions[corner[0]], striped.positions[corner[1]],
                                 striped.positions[corner[2]]};
        const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], cross = glm::cross(a, b);
        const double twice_area = glm::length(cross);
        if (!(twice_area > 0.0)) continue;
        const double u[3] = {striped.mesh.coordinate[corner[0]], striped.mesh.coordinate[corner[1]],
                             striped.mesh.coordinate[corner[2]]};
        const double growth = glm::length((u[1] - u[0]) * b - (u[2] - u[0]) * a) / twice_area;
        double rate = 0.0;
        for (const std::uint32_t v : f.sheets.triangles[t]) rate += rates[v] / 3.0;
        all += twice_area;
        if (growth < 0.25 * rate) low += twice_area;
    }
    return low / all;
}

// Away from umbilics: where the reference's confidence in a direction is at least one half. Against the field of
// docs/stripes.md as the test computes it in other ways (line_reference.h).
TEST(DirectionField, StripesOfTheBunnyFollowTheReferenceField) {
    Bunny bunny;
    if (!read_bunny(bunny)) GTEST_SKIP() << "no bunny here";
    StripeSettings settings;
    settings.crease_angle = 4.0;
    const Striped striped(bunny.positions, bunny.normals, bunny.indices, settings);
    striped.expect_sound(bunny.positions.size(), bunny.indices);
    const reference::LineField lines(bunny.positions, bunny.indices, settings.detail);
    std::vector<double> sure, all;
    std::size_t faded = 0;
    for (std::size_t v = 0; v < bunny.positions.size(); ++v) {
        const double degrees = line_degrees(striped.direction(v), lines.direction[v]);
        all.push_back(degrees);
        if (lines.confidence[v] >= 0.5) sure.push_back(degrees);
        if (striped.mesh.weight[v] == 0.0f) ++faded;
    }
    RecordProperty("sure_vertices", static_cast<int>(sure.size()));
    RecordProperty("median_degrees", std::to_string(quantile(sure, 0.5)));
    RecordProperty("p90_degrees", std::to_string(quantile(sure, 0.9)));
    RecordProperty("all_median_degrees", std::to_string(quantile(all, 0.5)));
    EXPECT_GT(sure.size(), all.size() / 2);
    const double flat = collapsed(striped, bunny, settings);
    RecordProperty("percent_under_a_quarter", std::to_string(100.0 * flat));
    EXPECT_LT(flat, 0.01);
    EXPECT_LT(quantile(sure, 0.5), 3.0);
    EXPECT_LT(faded, all.size() / 100);
}

} // namespace
} // namespace hachure::geometry
