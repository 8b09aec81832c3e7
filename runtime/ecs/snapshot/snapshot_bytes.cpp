#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>

namespace hachure::detail {

// Not inline: g++ 12 takes the insertion of a few bytes for an overflow where it knows the vector to be empty.
void ByteWriter::bytes(Bytes bytes) { out_->insert(out_->end(), bytes.begin(), bytes.end()); }

} // namespace hachure::detail
