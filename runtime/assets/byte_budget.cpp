#include <hachure/runtime/assets/byte_budget.h>
#include <hachure/runtime/error.h>

namespace hachure::assets {

void ByteBudget::spend(std::uint64_t count, std::uint64_t element_bytes, std::string_view where) {
    if (element_bytes != 0 && count > (limit_ - spent_) / element_bytes)
        throw Error(file_, "claims more data than a file of its size can hold", where);
    spent_ += count * element_bytes;
}

} // namespace hachure::assets
