// Time of reading mesh files over OpenMesh's own readers, alternating in one run.

#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using namespace hachure;

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";

std::size_t read_with_openmesh(const std::filesystem::path& file) {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    if (!OpenMesh::IO::read_mesh(mesh, file.string())) throw Error(file.string(), "OpenMesh can't read it");
    return mesh.n_faces();
}

std::size_t read_with_hachure(const std::filesystem::path& file) {
    return assets::read_mesh(file).meshes.front().primitives.front().indices.size() / 3;
}

int run(int argc, char** argv) {
    const bench::Arguments arguments = bench::parse_arguments(argc, argv, "Reading a mesh file, against OpenMesh.");
    const std::filesystem::path file = arguments.model.empty() ? bunny : arguments.model;
    const int rounds = arguments.quick ? 1 : 15;
    std::vector<double> ours, theirs, ratio;
    std::size_t triangles = 0, rival_triangles = 0;
    for (int i = 0; i < rounds; ++i) {
        const double start = bench::now_ms();
        triangles = read_with_hachure(file);
        const double middle = bench::now_ms();
        rival_triangles = read_with_openmesh(file);
        const double end = bench::now_ms();
        ours.push_back(middle - start);
        theirs.push_back(end - middle);
        ratio.push_back((middle - start) / (end - middle));
    }
    bench::Report report(arguments);
    report.add("triangles read", static_cast<double>(triangles), "");
    report.add("triangles that OpenMesh keeps", static_cast<double>(rival_triangles), "");
    report.add("reading", bench::median(ours), "ms");
    report.add("OpenMesh reading", bench::median(theirs), "ms");
    report.add_limited("reading over OpenMesh", bench::median(ratio), "ratio", 0.5);

    const assets::Model model = assets::read_mesh(file);
    const assets::Primitive& primitive = model.meshes.front().primitives.front();
    const double start = bench::now_ms();
    const geometry::EdgeTable table = geometry::build_edge_table(primitive.positions, primitive.indices);
    report.add("edge table of " + std::to_string(table.edges.size()) + " edges", bench::now_ms() - start, "ms");
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_assets: error: %s\n", error.what());
        return 1;
    }
}
