#include <hachure/components/surface.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/curvature/surface_curvature.h>

#include <deque>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using Bending = Query<const Surface, const Curvature, Optional<const Deform>, Optional<const Deformed>>;

class CurvatureSystem {
public:
    void operator()(Bending surfaces, Query<PrincipalCurvatures> results, Removed<Curvature> unwanted, LastRun last,
                    const MeshStore& store, CurvatureCounts& counts, Commands& commands) {
        counts = {};
        for (const Entity entity : unwanted) {
            if (surfaces.contains(entity)) continue;
            work_.erase(entity);
            commands.remove<PrincipalCurvatures>(entity);
        }
        collect(surfaces, results, last, store);
        parallel_for(tasks_.size(), [this](std::size_t i) { tasks_[i].run(); });
        for (const Task& task : tasks_) ++(task.carries() ? counts.carried : counts.recomputed);
        for (auto& [entity, result] : newcomers_) commands.add(entity, std::move(result));
        tasks_.clear();
        newcomers_.clear();
    }

private:
    struct Task {
        SurfaceCurvature* work;
        const SurfaceMesh* mesh;
        Curvature wanted;
        Deform settings;
        const Deformed* shape;
        PrincipalCurvatures* out;

        /// Without a skin there is nothing to carry it with.
        bool carries() const { return wanted.source == CurvatureSource::carried && shape && !shape->palette.empty(); }
        void run() const {
            if (carries())
                work->carry(*mesh, wanted, settings, *shape, *out);
            else
                work->recompute(*mesh, wanted, shape, *out);
        }
    };

    void collect(const Bending& surfaces, const Query<PrincipalCurvatures>& results, LastRun last,
                 const MeshStore& store) {
        for (auto [entity, surface, wanted, settings, shape] :
             surfaces.changed_since<Surface, Curvature, Deform, Deformed>(last.tick)) {
            std::unique_ptr<SurfaceCurvature>& work = work_[entity];
            if (!work) work = std::make_unique<SurfaceCurvature>();
            const auto found = results.find(entity);
            PrincipalCurvatures& out = found ? std::get<PrincipalCurvatures&>(*found)
                                             : newcomers_.emplace_back(entity, PrincipalCurvatures{}).second;
            tasks_.push_back(
                {work.get(), &store.mesh(surface.mesh), wanted, settings ? *settings : Deform{}, shape, &out});
        }
    }

    std::unordered_map<Entity, std::unique_ptr<SurfaceCurvature>> work_;
    std::vector<Task> tasks_;
    std::deque<std::pair<Entity, PrincipalCurvatures>> newcomers_; ///< tasks point into it
};

} // namespace

void register_curvature(App& app) {
    app.add_component<Curvature>();
    World& world = app.world();
    if (!world.find_resource<MeshStore>()) world.set_resource(MeshStore{});
    world.set_resource(CurvatureCounts{});
    // Its memory is too much the system's own to be copied with it.
    app.add_system(Stage::deform, "curvature",
                   [system = std::make_shared<CurvatureSystem>()](
                       Bending surfaces, Query<PrincipalCurvatures> results, Removed<Curvature> unwanted, LastRun last,
                       const MeshStore& store, CurvatureCounts& counts,
                       Commands& commands) { (*system)(surfaces, results, unwanted, last, store, counts, commands); })
        .after("deform");
}

} // namespace hachure
