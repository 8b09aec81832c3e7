#pragma once

#include <cstdint>

namespace hachure::geometry {

/// The vector instructions that a job's inner loops are compiled for. Results differ between them by rounding only,
/// since the wider ones fuse multiplications with additions.
enum class InstructionSet : std::uint8_t {
    portable, ///< what the program is compiled for: 4 floats at once on any machine
    avx2,     ///< 8 floats, with FMA
    avx512,   ///< 16 floats
};

/// Whether this machine can run such code.
[[nodiscard]] bool is_supported(InstructionSet set);

/// The widest that this machine can run; asked once.
[[nodiscard]] InstructionSet best_instruction_set();

} // namespace hachure::geometry
