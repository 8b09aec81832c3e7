#include <hachure/runtime/geometry/instruction_set.h>

namespace hachure::geometry {

bool is_supported(InstructionSet set) {
    if (set == InstructionSet::portable) return true;
#if defined(__x86_64__)
    if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && is_supported(InstructionSet::avx2);
#else
    return false;
#endif
}

InstructionSet best_instruction_set() {
    static const InstructionSet best = is_supported(InstructionSet::avx512) ? InstructionSet::avx512
                                       : is_supported(InstructionSet::avx2) ? InstructionSet::avx2
                                                                            : InstructionSet::portable;
    return best;
}

} // namespace hachure::geometry
