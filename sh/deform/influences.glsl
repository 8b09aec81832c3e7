// Which palette entries a vertex follows, and how much.

// Joints as SkinWeights packs them, JOINT_BITS each, then weights as floats. Unpacked here and not on upload: they are
// a quarter of the memory for most skins, and shifts are cheaper than reads.
layout(std430, binding = 4) readonly buffer Influences { uint influences[]; };

uniform uint first_entry;  // of the palette, into `poses`
uniform uint weight_words; // where the weights begin in `influences`

// Where the palette entry of influence `i` begins in `poses`; vertices have INFLUENCES each.
uint entry_of(uint i) {
#if JOINT_BITS == 32
    uint joint = influences[i];
#else
    const uint per_word = 32u / uint(JOINT_BITS);
    uint joint = bitfieldExtract(influences[i / per_word], int(i % per_word) * JOINT_BITS, JOINT_BITS);
#endif
    return first_entry + 4u * joint;
}

float weight_of(uint i) { return uintBitsToFloat(influences[weight_words + i]); }
