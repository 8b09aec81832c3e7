#include <hachure/tests/runtime/geometry/striped.h>

#include <limits>
#include <map>
#include <numbers>
#include <random>

namespace hachure::geometry {
namespace {

using std::numbers::pi;

/// Degrees between the drawn direction across stripes and the closed form, around the tube, at every vertex.
std::vector<double> torus_errors(const Striped& striped, double major) {
    std::vector<double> errors;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const glm::dvec3 p(striped.positions[v]);
        const glm::dvec3 around = glm::normalize(glm::dvec3(p.x, 0.0, p.z));
        const glm::dvec3 from_core = glm::normalize(p - major * around);
        const glm::dvec3 across = glm::cross(glm::cross(glm::dvec3(0.0, 1.0, 0.0), around), from_core);
        errors.push_back(line_degrees(striped.direction(v), across));
    }
    return errors;
}

TEST(StripeMesh, FollowsTheTubeOfATorus) {
    const Shape regular = torus(1.0, 0.4, 80, 32), irregular = irregular_torus(1.0, 0.4, 100, 40, 0.33, 5);
    for (const auto& [shape, bound] : {std::pair(&regular, 0.3), std::pair(&irregular, 1.0)}) {
        const Striped striped(*shape);
        striped.expect_sound(shape->positions.size(), shape->indices);
        const std::vector<double> errors = torus_errors(striped, 1.0);
        RecordProperty("median_degrees", std::to_string(quantile(errors, 0.5)));
        EXPECT_LT(quantile(errors, 0.5), bound);
        EXPECT_LT(quantile(errors, 0.99), 4.0 * bound);
        for (const float weight : striped.mesh.weight) EXPECT_EQ(weight, 1.0f); // no singularity
        // One set per half turn, twice around the tube.
        for (const glm::vec4& frame : striped.frames) EXPECT_NEAR(frame.w, pi, 0.25 * pi);
    }
}

/// By how many sets u grows along the corners of one ring of a surface of revolution around Y, jumps left out.
double sets_around(const Striped& striped, double height, double radius) {
    double sum = 0.0;
    for (std::size_t i = 0; i < striped.mesh.indices.size(); ++i) {
        const std::uint32_t a = striped.mesh.indices[i], b = striped.mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        const auto on_ring = [&](std::uint32_t v) {
            const glm::dvec3 p(striped.positions[v]);
            return std::abs(p.y - height) < 1e-6 && std::abs(std::hypot(p.x, p.z) - radius) < 1e-6;
        };
        if (!on_ring(a) || !on_ring(b) || std::abs(striped.normals[a].y) > 0.99f) continue;
        sum += std::abs(striped.mesh.coordinate[b] - striped.mesh.coordinate[a]);
    }
    return sum;
}

TEST(StripeMesh, LaysStraightStreaksOnACylinderAWholeNumberOfTimesAround) {
    for (const double height : {0.5, 1.0, 2.0, 10.0}) {
        const Striped striped(cylinder(0.5, height, 48));
        for (std::size_t v = 0; v < striped.positions.size(); ++v) {
            const glm::dvec3 n(striped.normals[v]);
            const glm::dvec3 along = std::abs(n.y) > 0.99 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
            EXPECT_LT(std::abs(glm::dot(striped.direction(v), along)), 0.01) << height << ' ' << v;
        }
        EXPECT_NEAR(sets_around(striped, 0.5 * height, 0.5), 2.0, 1e-3) << height;
    }
}

TEST(StripeMesh, MoreSetsOnDemand) {
    for (const double sets : {2.0, 3.0, 5.0}) {
        const Striped striped(cylinder(0.5, 2.0, 48), {.sets = sets});
        EXPECT_NEAR(sets_around(striped, 1.0, 0.5), 2.0 * sets, 1e-3);
    }
}

TEST(StripeMesh, StreaksOfAConeMeetInItsTip) {
    const Striped striped(cone(0.5, 1.0, 32));
    EXPECT_NEAR(sets_around(striped, -0.5, 0.5), 2.0, 1e-3);
    for (const float weight : striped.mesh.weight) EXPECT_EQ(weight, 1.0f); // nothing fades
    // Along a meridian u stays: the tip of every slice has what the middle below it has.
    for (std::size_t i = 0; i < striped.mesh.indices.size(); i += 3) {
        const std::uint32_t* v = &striped.mesh.indices[i];
        for (int k = 0; k < 3; ++k) {
            if (striped.positions[v[k]].y < 0.49f) continue;
            const float middle =
                0.5f * (striped.mesh.coordinate[v[(k + 1) % 3]] + striped.mesh.coordinate[v[(k + 2) % 3]]);
            EXPECT_NEAR(striped.mesh.coordinate[v[k]], middle, 1e-5f);
        }
    }
}

/// What is drawn at the corners of all triangles, in their order.
std::vector<double> drawn(const StripeMesh& mesh) {
    std::vector<double> result;
    for (const std::uint32_t v : mesh.indices)
        result.push_back(mesh.weight[v] > 0.0f ? Striped::folded(mesh.coordinate[v]) : -1.0);
    return result;
}

Shape smooth_cube() {
    Shape shape = cube(1.0);
    for (std::size_t v = 0; v < shape.positions.size(); ++v) shape.normals[v] = glm::normalize(shape.positions[v]);
    return shape;
}

TEST(StripeMesh, TheLastBitOfPositionsChangesLittle) {
    const std::pair<const char*, Shape> shapes[] = {
        {"sphere", uv_sphere(1.0, 48, 24)},  {"icosphere", icosphere(1.0, 4)},
        {"plane", plane(2.0, 12)},           {"cube", cube(1.0)},
        {"smooth cube", smooth_cube()},      {"torus", torus(1.0, 0.4, 48, 20)},
        {"cylinder", cylinder(0.5, 2.0, 32)}};
    for (const auto& [name, shape] : shapes) {
        SCOPED_TRACE(name);
        const std::vector<double> before = drawn(make_stripe_mesh(shape.positions, shape.normals, shape.indices));
        for (const unsigned seed : {1u, 2u, 3u}) {
            std::mt19937 random(seed);
            std::map<std::array<float, 3>, glm::vec3> moved; // vertices at one place move together
            Shape other = shape;
            for (glm::vec3& p : other.positions) {
                const auto [found, is_new] = moved.try_emplace({p.x, p.y, p.z}, p);
                for (int i = 0; is_new && i < 3; ++i)
                    found->second[i] = std::nextafter(p[i], random() % 2 == 0 ? 2.0f : -2.0f);
                p = found->second;
            }
            const std::vector<double> after = drawn(make_stripe_mesh(other.positions, other.normals, other.indices));
            ASSERT_EQ(before.size(), after.size());
            double most = 0.0;
            std::size_t faded = 0;
            for (std::size_t i = 0; i < before.size(); ++i) {
                if ((before[i] < 0.0) != (after[i] < 0.0)) ++faded; // a singularity moved to the next triangle
                if (before[i] >= 0.0 && after[i] >= 0.0) most = std::max(most, std::abs(before[i] - after[i]));
            }
            EXPECT_LT(most, 0.01);
            EXPECT_LE(static_cast<double>(faded), 0.01 * static_cast<double>(before.size()));
        }
    }
}

TEST(StripeMesh, FlatPartsHaveStreaksAlongYOrX) {
    const Striped striped(cube(1.0));
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const glm::dvec3 along =
            std::abs(striped.normals[v].y) > 0.5f ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        EXPECT_LT(std::abs(glm::dot(striped.direction(v), along)), 1e-4);
        EXPECT_EQ(striped.mesh.weight[v], 1.0f);
        EXPECT_EQ(striped.frames[v].w, 0.0f);
    }
    const Striped floor(plane(2.0, 8));
    for (std::size_t v = 0; v < floor.positions.size(); ++v) EXPECT_NEAR(std::abs(floor.frames[v].z), 1.0f, 1e-4f);
}

TEST(StripeMesh, AUnitSphereHasMeridiansFromPoleToPole) {
    const Striped striped(icosphere(1.0, 4));
    std::vector<double> errors;
    std::size_t faded = 0;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const glm::dvec3 p(striped.positions[v]);
        if (striped.mesh.weight[v] == 0.0f) {
            ++faded;
            EXPECT_GT(std::abs(p.y), 0.85);
        }
        if (std::abs(p.y) < 0.7)
            errors.push_back(line_degrees(striped.direction(v), glm::cross(p, glm::dvec3(0.0, 1.0, 0.0))));
    }
    EXPECT_LE(faded, 4u * 8u); // corners of four half turns, two near each pole, and their copies
    EXPECT_LT(quantile(errors, 0.5), 6.0);
}

TEST(StripeMesh, FollowsAnEllipsoid) {
    // Of revolution around X, so that the direction of most curvature is around X (radius 0.5 there).
    Shape shape = icosphere(1.0, 4);
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
        const glm::vec3 p = shape.positions[v];
        shape.positions[v] = p * glm::vec3(2.0f, 0.5f, 0.5f);
        shape.normals[v] = glm::normalize(p / glm::vec3(2.0f, 0.5f, 0.5f));
    }
    const Striped striped(shape);
    std::vector<double> errors;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const glm::dvec3 p(striped.positions[v]);
        if (std::abs(p.x) < 1.6)
            errors.push_back(line_degrees(striped.direction(v), glm::cross(glm::dvec3(1.0, 0.0, 0.0), p)));
    }
    RecordProperty("median_degrees", std::to_string(quantile(errors, 0.5)));
    EXPECT_LT(quantile(errors, 0.5), 2.0);
    EXPECT_LT(quantile(errors, 0.9), 6.0);
}

TEST(StripeMesh, NeighboursDrawTheSameAtTheirEdge) {
    const Shape shapes[] = {icosphere(1.0, 3), torus(1.0, 0.4, 40, 16), cone(0.5, 1.0, 16)};
    for (const Shape& shape : shapes) {
        const Striped striped(shape);
        // Per edge between places: what is drawn at its middle, by every triangle whose corners all count.
        std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, std::vector<double>> middles;
        const std::vector<std::uint32_t>& indices = striped.mesh.indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = indices[i + k], b = indices[i + (k + 1) % 3], c = indices[i + (k + 2) % 3];
                if (striped.mesh.weight[a] == 0.0f || striped.mesh.weight[b] == 0.0f || striped.mesh.weight[c] == 0.0f)
                    continue;
                if (glm::dot(striped.normals[a], striped.normals[c]) < 0.5f) continue;
                const glm::vec3 p = striped.positions[a], q = striped.positions[b];
                if (p.y > 0.49f || q.y > 0.49f) continue; // the cone's tip
                std::array<float, 3> low{p.x, p.y, p.z}, high{q.x, q.y, q.z};
                if (high < low) std::swap(low, high);
                middles[{low, high}].push_back(
                    Striped::folded(0.5 * (double{striped.mesh.coordinate[a]} + double{striped.mesh.coordinate[b]})));
            }
        }
        std::size_t compared = 0, different = 0;
        for (const auto& [edge, values] : middles) {
            for (std::size_t i = 1; i < values.size(); ++i) {
                ++compared;
                if (std::abs(values[i] - values[0]) > 1e-4) ++different;
            }
        }
        EXPECT_GT(compared, shape.indices.size() / 6);
        // Where the cone is cut from its base, both sides draw their own.
        EXPECT_LE(different, shape.positions.size() < 100 ? 16u : 0u);
    }
}

TEST(StripeMesh, TheFrameOfAVertexIsTheSameOnBothSidesOfAJump) {
    const Striped striped(icosphere(1.0, 3));
    std::size_t repeated = 0;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const std::uint32_t stands = striped.mesh.stands_for[v];
        if (stands == v) continue;
        ++repeated;
        const float sign = striped.mesh.mirrored[v] != striped.mesh.mirrored[stands] ? -1.0f : 1.0f;
        EXPECT_EQ(glm::vec3(striped.frames[v]), sign * glm::vec3(striped.frames[stands]));
        EXPECT_EQ(striped.frames[v].w, striped.frames[stands].w);
        EXPECT_NEAR(Striped::folded(striped.mesh.coordinate[v]), Striped::folded(striped.mesh.coordinate[stands]),
                    1e-5);
    }
    EXPECT_GT(repeated, 10u);
}

TEST(StripeMesh, IsTheSameOnEveryRun) {
    const Shape shape = irregular_torus(1.0, 0.4, 30, 12, 0.3, 2);
    EXPECT_EQ(make_stripe_mesh(shape.positions, shape.normals, shape.indices),
              make_stripe_mesh(shape.positions, shape.normals, shape.indices));
}

TEST(StripeMesh, IsDefinedOnBrokenMeshes) {
    std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},    {0, 0, 1},
                                {1, 1, 1}, {0, 0, 0}, {0.5f, 0, 0}, {9, 9, 9}};
    const std::vector<std::vector<std::uint32_t>> meshes = {
        {},
        {0, 1, 2},
        {0, 0, 0},                            // a point
        {0, 5, 1},                            // two corners at one place
        {0, 6, 1},                            // on a line
        {0, 1, 2, 0, 1, 2, 0, 2, 1},          // repeated, and from behind
        {0, 1, 2, 0, 1, 3, 0, 1, 4, 1, 0, 2}, // an edge with four
        {0, 1, 2, 3, 4, 5},                   // that touch in a point
        {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, // a tetrahedron
        {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 3, 2}, // with sides that disagree
    };
    for (const auto& indices : meshes) {
        for (const float scale : {1.0f, 1e-15f, 1e12f}) {
            std::vector<glm::vec3> scaled;
            for (const glm::vec3& v : p) scaled.push_back(scale * v);
            SCOPED_TRACE(indices.size());
            const Striped striped(scaled, {}, indices);
            striped.expect_sound(p.size(), indices);
        }
    }
}

TEST(StripeMesh, IsDefinedOnSoup) {
    std::mt19937 engine(4);
    const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
    for (int round = 0; round < 40; ++round) {
        std::vector<glm::vec3> p;
        std::vector<std::uint32_t> indices;
        const std::uint32_t count = 4 + random() % 40;
        for (std::uint32_t v = 0; v < count; ++v) // on a coarse grid: many coincide or lie on lines
            p.emplace_back(static_cast<float>(random() % 4), static_cast<float>(random() % 4),
                           static_cast<float>(random() % 3));
        const std::uint32_t corners = 3 * (count + random() % 60);
        for (std::uint32_t i = 0; i < corners; ++i) indices.push_back(random() % count);
        const Striped striped(p, {}, indices);
        striped.expect_sound(p.size(), indices);
        if (testing::Test::HasFatalFailure()) return;
    }
}

} // namespace
} // namespace hachure::geometry
