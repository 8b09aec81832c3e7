#include <hachure/runtime/ecs/parallel.h>

#include <tbb/parallel_for.h>
namespace hachure {
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { body(i); });
}
} // namespace hachure
