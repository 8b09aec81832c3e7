#include <hachure/runtime/ecs/storage/component_record.h>
#include <hachure/runtime/ecs/storage/sparse_store.h>

namespace hachure::detail {

ComponentRecord::ComponentRecord(const ComponentInfo& of) : info(&of) {}
ComponentRecord::~ComponentRecord() = default;

} // namespace hachure::detail
