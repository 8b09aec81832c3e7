// What skinning, morphing and curvature cost per vertex, on one core; skinning as a ratio to a plain loop over the same
// bytes, measured in turn with it. The best of many rounds: other programs only ever add time.

#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/deformed_bounds.h>
#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/deform_chart.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hachure;
using namespace hachure::geometry;

/// A large character: a torus cut into as many bones as a hero has, each vertex following those around it.
struct Character {
    static constexpr std::size_t joint_count = 48;

    Shape shape;
    std::vector<glm::vec4> tangents;
    SkinWeights four, eight, scattered; ///< neighbours follow the same joints, but for `scattered`
    std::vector<JointMatrix> palette = std::vector<JointMatrix>(joint_count + 1);
    std::vector<JointMotion> motions = std::vector<JointMotion>(joint_count + 1);
    std::vector<glm::dmat4> joints;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> moved_tangents;

    explicit Character(std::uint32_t across) : shape(irregular_torus(1.0, 0.2, 4 * across, across, 0.2, 1)) {
        const std::size_t count = shape.positions.size();
        std::vector<glm::u16vec4> sets[2], any;
        std::vector<glm::vec4> weights[2];
        for (std::size_t v = 0; v < count; ++v) {
            const std::size_t bone = v * joint_count / count;
            for (std::size_t set = 0; set < 2; ++set) {
                glm::u16vec4 joint;
                for (std::size_t k = 0; k < 4; ++k)
                    joint[static_cast<int>(k)] = static_cast<std::uint16_t>((bone + 4 * set + k) % joint_count);
                sets[set].push_back(joint);
                weights[set].push_back(glm::vec4(4, 3, 2, 1) / (set == 0 ? 12.0f : 60.0f));
            }
            any.push_back(glm::u16vec4(v * 7, v * 7 + 11, v * 7 + 23, v * 7 + 31) % glm::u16vec4(joint_count));
            tangents.emplace_back(glm::normalize(glm::cross(shape.normals[v], glm::vec3(0.1f, 0.2f, 0.9f))), 1.0f);
        }
        four = pack_skin_weights(count, joint_count, sets[0], weights[0]);
        scattered = pack_skin_weights(count, joint_count, any, weights[0]);
        eight = pack_skin_weights(count, joint_count, sets[0], weights[0], sets[1], weights[1]);
        for (std::size_t j = 0; j < joint_count; ++j)
            joints.push_back(glm::rotate(glm::dmat4(1.0), 0.02 * static_cast<double>(j), glm::dvec3(0.6, 0.8, 0.0)));
        positions.resize(count);
        normals.resize(count);
        moved_tangents.resize(count);
        palette_job(true).run();
    }

    SkinPaletteJob palette_job(bool with_motions) {
        SkinPaletteJob job{.joints_double = joints, .palette = palette};
        if (with_motions) job.motions = motions;
        return job;
    }

    SkinJob skin_job(SkinMethod method) {
        return {.method = method,
                .rest_positions = shape.positions,
                .rest_normals = shape.normals,
                .weights = &four,
                .palette = palette,
                .motions = motions,
                .positions = positions,
                .normals = normals};
    }
};

/// The floor: reads and writes what skinning does, with hardly anything to compute.
[[gnu::noinline]] void plain_loop(const Character& from, std::vector<glm::vec3>& positions,
                                  std::vector<glm::vec3>& normals) {
    const auto* joints = reinterpret_cast<const std::uint8_t*>(from.four.packed_joints().data());
    const float* weights = from.four.weights().data();
    const std::size_t count = positions.size();
    for (std::size_t v = 0; v < count; ++v) {
        const float* w = weights + 4 * v;
        const std::uint8_t* j = joints + 4 * v;
        const float scale = w[0] + w[1] + w[2] + w[3] + static_cast<float>(j[0] + j[1] + j[2] + j[3]);
        positions[v] = scale * from.shape.positions[v];
        normals[v] = scale * from.shape.normals[v];
    }
}

/// Jobs that are timed in turn; the best of each.
class Rounds {
public:
    void add(std::function<void()> job) { jobs_.push_back(std::move(job)); }

    /// Milliseconds of each, in the order in which they were added.
    std::vector<double> run(int rounds) const {
        std::vector<double> best(jobs_.size(), std::numeric_limits<double>::max());
        for (int i = 0; i < rounds; ++i)
            for (std::size_t j = 0; j < jobs_.size(); ++j) {
                const double start = bench::now_ms();
                jobs_[j]();
                best[j] = std::min(best[j], bench::now_ms() - start);
            }
        return best;
    }

private:
    std::vector<std::function<void()>> jobs_;
};

void report_skinning(bench::Report& report, Character& character, int rounds) {
    SkinJob linear = character.skin_job(SkinMethod::linear), parallel = linear, eight = linear, scattered = linear,
            tangents = linear, avx2 = linear, portable = linear, dual = character.skin_job(SkinMethod::dual_quaternion);
    eight.weights = &character.eight;
    scattered.weights = &character.scattered;
    tangents.rest_tangents = character.tangents;
    tangents.tangents = character.moved_tangents;
    if (is_supported(InstructionSet::avx2)) avx2.instructions = InstructionSet::avx2;
    portable.instructions = InstructionSet::portable;
    Rounds judged, others; // those that are compared run in turn with nothing between them, and more often
    judged.add([&] { plain_loop(character, character.positions, character.normals); });
    judged.add([&] { linear.run(); });
    judged.add([&] { skin_in_parallel(parallel); });
    for (SkinJob* job : {&eight, &scattered, &tangents, &dual, &avx2, &portable}) others.add([job] { job->run(); });
    std::vector<double> ms = judged.run(8 * rounds);
    std::ranges::copy(others.run(rounds), std::back_inserter(ms));
    const double ns = 1e6 / static_cast<double>(character.positions.size());
    report.add("vertices", static_cast<double>(character.positions.size()), "");
    report.add("plain loop over the same bytes", ms[0] * ns, "ns/vertex");
    report.add("LBS: 4 influences", ms[1] * ns, "ns/vertex");
    report.add_limited("LBS: 4 influences / plain loop", ms[1] / ms[0], "ratio", 1.5);
    report.add("LBS: on all threads", ms[2] * ns, "ns/vertex");
    if (thread_limit() > 1) report.add_limited("LBS: all threads / one", ms[2] / ms[1], "ratio", 0.7);
    report.add("LBS: 8 influences", ms[3] * ns, "ns/vertex");
    report.add("LBS: 4 influences, neighbours unlike", ms[4] * ns, "ns/vertex");
    report.add("LBS: 4 influences and tangents", ms[5] * ns, "ns/vertex");
    report.add("DQS: 4 influences", ms[6] * ns, "ns/vertex");
    report.add("LBS: AVX2", ms[7] * ns, "ns/vertex");
    report.add("LBS: portable", ms[8] * ns, "ns/vertex");
}

void report_palette(bench::Report& report, Character& character, int rounds) {
    SkinPaletteJob matrices = character.palette_job(false), motions = character.palette_job(true);
    const std::vector<Bounds> boxes = rest_joint_bounds(character.four, character.shape.positions);
    Bounds bounds;
    Rounds all;
    all.add([&] { matrices.run(); });
    all.add([&] { motions.run(); });
    all.add([&] { bounds.include(deformed_bounds(boxes, character.palette)); });
    const std::vector<double> ms = all.run(50 * rounds);
    const double ns = 1e6 / static_cast<double>(Character::joint_count);
    report.add("palette: matrices", ms[0] * ns, "ns/joint");
    report.add("palette: matrices and motions", ms[1] * ns, "ns/joint");
    report.add("bounds without vertices", ms[2] * ns, "ns/joint");
}

/// Sixteen targets of which each moves a sixteenth of the mesh, with normals.
void report_morphing(bench::Report& report, Character& character, int rounds) {
    const std::size_t count = character.positions.size(), target_count = 16;
    std::vector<std::vector<glm::vec3>> deltas(target_count, std::vector<glm::vec3>(count, glm::vec3(0.0f)));
    std::vector<MorphDeltas> given;
    for (std::size_t t = 0; t < target_count; ++t) {
        for (std::size_t v = t * count / target_count; v < (t + 1) * count / target_count; ++v)
            deltas[t][v] = 0.1f * character.shape.normals[v];
        given.push_back({.positions = deltas[t], .normals = deltas[t]});
    }
    const MorphTargets targets(count, given);
    std::vector<float> none(target_count, 0.0f), two = none, every(target_count, 0.5f);
    two[3] = two[7] = 0.5f;
    MorphJob job{.base_positions = character.shape.positions,
                 .base_normals = character.shape.normals,
                 .targets = &targets,
                 .positions = character.positions,
                 .normals = character.normals};
    Rounds all;
    for (const std::vector<float>* weights : {&none, &two, &every})
        all.add([&job, weights] {
            job.weights = *weights;
            job.run();
        });
    const std::vector<double> ms = all.run(rounds);
    const double ns = 1e6 / static_cast<double>(count);
    report.add("morph: 16 targets of weight zero", ms[0] * ns, "ns/vertex");
    report.add("morph: two of 16 targets", ms[1] * ns, "ns/vertex");
    report.add("morph: all of 16 targets", ms[2] * ns, "ns/vertex");
    report.add("morph: stored / dense", static_cast<double>(targets.bytes()) / static_cast<double>(24 * 16 * count),
               "ratio");
}

/// On a mesh of the size that is recomputed every frame.
void report_curvature(bench::Report& report, std::uint32_t across, int rounds) {
    Character character(across);
    const std::size_t count = character.positions.size();
    std::vector<std::uint32_t> weld(count);
    for (std::uint32_t v = 0; v < count; ++v) weld[v] = v;
    std::vector<glm::vec2> curvatures(count), carried(count);
    std::vector<glm::vec3> directions(count), carried_directions(count);
    SkinJob skin = character.skin_job(SkinMethod::linear);
    skin.run();
    SmoothNormalsJob normals{.positions = character.positions,
                             .indices = character.shape.indices,
                             .weld = weld,
                             .normals = character.normals};
    normals.run();
    CurvatureJob curvature{.positions = character.positions,
                           .normals = character.normals,
                           .indices = character.shape.indices,
                           .weld = weld,
                           .curvatures = curvatures,
                           .directions = directions};
    curvature.run();
    CarryCurvatureJob carry{.rest_normals = character.shape.normals,
                            .rest_curvatures = curvatures,
                            .rest_directions = directions,
                            .weights = &character.four,
                            .palette = character.palette,
                            .motions = character.motions,
                            .curvatures = carried,
                            .directions = carried_directions};
    CarryCurvatureJob carry_dual = carry;
    carry_dual.method = SkinMethod::dual_quaternion;
    Rounds all;
    all.add([&] { normals.run(); });
    all.add([&] { curvature.run(); });
    all.add([&] { carry.run(); });
    all.add([&] { carry_dual.run(); });
    const std::vector<double> ms = all.run(rounds);
    const double us = 1e3 / static_cast<double>(count);
    report.add("normals recomputed", ms[0] * us, "us/vertex");
    report.add_limited("curvature recomputed", ms[1] * us, "us/vertex", 0.9);
    report.add("curvature carried: LBS", ms[2] * us, "us/vertex");
    report.add("curvature carried: DQS", ms[3] * us, "us/vertex");
}

int run(const bench::Arguments& arguments) {
    const int rounds = arguments.quick ? 1 : 40;
    bench::Report report(arguments);
    {
        Character character(arguments.quick ? 16 : 360); // 518400 vertices
        report_skinning(report, character, rounds);
        report_palette(report, character, rounds);
        report_morphing(report, character, rounds);
    }
    report_curvature(report, arguments.quick ? 16 : 100, rounds);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        // `--chart FILE [--quick]` writes what deform_chart.gp draws, and measures nothing else.
        if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
            bench::write_deform_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
            return 0;
        }
        return run(bench::parse_arguments(argc, argv, "Skinning, morphing and curvature of meshes that deform."));
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_deform: error: %s\n", error.what());
        return 1;
    }
}
