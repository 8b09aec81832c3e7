#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/snapshot/snapshot_column.h>
#include <hachure/runtime/ecs/snapshot/snapshot_field.h>
#include <hachure/runtime/ecs/snapshot/snapshot_gather.h>

#include <fmt/format.h>

namespace hachure::detail {
namespace {

struct Gather {
    const FieldInfo& field;
    std::span<const void* const> components;
    Bytes default_value; ///< as it lies in memory
    Bits& given;
    std::vector<std::byte>& values; ///< holds anything before

    const std::byte* member(std::size_t row) const {
        return static_cast<const std::byte*>(components[row]) + field.offset;
    }
};

/// Values that are written as they lie in memory. Compared by bytes: -0 is not 0.
template <std::size_t width> void gather_plain(const Gather& job) {
    HACHURE_ASSERT(job.field.size == width, "a value is written as it lies in memory");
    std::byte same[width];
    std::memcpy(same, job.default_value.data(), width);
    job.values.resize(job.components.size() * width);
    std::byte* out = job.values.data();
    for (std::size_t row = 0; row < job.components.size(); ++row) {
        std::byte value[width];
        std::memcpy(value, job.member(row), width);
        const bool differs = std::memcmp(value, same, width) != 0;
        std::memcpy(out, value, width); // always, and kept when it counts: without a branch
        out += differs ? width : 0;
        job.given.set(static_cast<std::uint32_t>(row), differs);
    }
    job.values.resize(static_cast<std::size_t>(out - job.values.data()));
}

void gather_text(const Gather& job) {
    const auto& same = std::get<std::string>(job.field.default_value);
    job.values.clear();
    ByteWriter out(job.values);
    for (std::size_t row = 0; row < job.components.size(); ++row) {
        const auto& text = *reinterpret_cast<const std::string*>(job.member(row));
        if (text == same) continue;
        job.given.set(static_cast<std::uint32_t>(row));
        out.number(static_cast<std::uint32_t>(text.size()));
        out.bytes(bytes_of(text));
    }
}

/// Enumerators have the size that their enumeration chose; their numbers begin at 0.
std::uint64_t enumerator(const Gather& job, std::size_t row) {
    std::uint64_t index = 0;
    std::memcpy(&index, job.member(row), job.field.size);
    if (index >= job.field.options.size()) throw Error(job.field.path, fmt::format("{} is none of its options", index));
    return index;
}

void gather_enumeration(const Gather& job) {
    std::uint16_t same = 0;
    std::memcpy(&same, job.default_value.data(), sizeof same);
    job.values.clear();
    ByteWriter out(job.values);
    for (std::size_t row = 0; row < job.components.size(); ++row) {
        const auto index = static_cast<std::uint16_t>(enumerator(job, row));
        if (index == same) continue;
        job.given.set(static_cast<std::uint32_t>(row));
        out.number(index);
    }
}

void gather(ValueCode code, const Gather& job) {
    if (code == ValueCode::text) return gather_text(job);
    if (code == ValueCode::enumeration) return gather_enumeration(job);
    switch (width(code)) {
    case 1:
        return gather_plain<1>(job);
    case 4:
        return gather_plain<4>(job);
    case 8:
        return gather_plain<8>(job);
    case 12:
        return gather_plain<12>(job);
    case 16:
        return gather_plain<16>(job);
    default:
        HACHURE_ASSERT(false, "every width of a value is listed here");
    }
}

} // namespace

void write_field_column(ByteWriter& out, const FieldInfo& field, std::span<const void* const> components,
                        std::vector<std::byte>& scratch) {
    const ValueCode code = value_code(field);
    const OptionNames options = option_names(field);
    std::vector<std::byte> default_value;
    ByteWriter defaults(default_value);
    encode_value(defaults, code, field.default_value, options);
    Bits given(static_cast<std::uint32_t>(components.size()));
    gather(code, {field, components, default_value, given, scratch});
    std::uint32_t count = 0;
    for (const std::uint64_t word : given.words()) count += static_cast<std::uint32_t>(std::popcount(word));
    if (const std::string fault = values_fault(field, count, scratch); !fault.empty()) throw Error(field.path, fault);
    write_column(out, field.name, code, options, default_value, given, scratch);
}

} // namespace hachure::detail
