// Vectors of floats of the width that the including file has chosen. Included by skin_loop.h only, once per
// instruction set, inside a namespace of its own: no include guard, no includes, no function of another header.
//
// Four neighbouring lanes form a quarter; all shuffles stay within quarters, which every instruction set does at once.

#define HACHURE_INLINE [[gnu::always_inline]] inline

using Quad = float __attribute__((vector_size(16)));
#if HACHURE_LANES == 4
using Lanes = Quad;
using Bits = int __attribute__((vector_size(16)));
#elif HACHURE_LANES == 8
using Lanes = float __attribute__((vector_size(32)));
using Bits = int __attribute__((vector_size(32)));
#else
using Lanes = float __attribute__((vector_size(64)));
using Bits = int __attribute__((vector_size(64)));
#endif

constexpr int lane_count = HACHURE_LANES;
constexpr int quarters = lane_count / 4;

HACHURE_INLINE Quad load_quad(const float* from) {
    Quad value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

HACHURE_INLINE Lanes load(const float* from) {
    Lanes value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

HACHURE_INLINE void store(float* to, const Lanes& value) { __builtin_memcpy(to, &value, sizeof value); }

HACHURE_INLINE Lanes all(float value) { return Lanes{} + value; }

/// Quarter q is the four floats at from + q * stride. (The generic shuffles would not become loads into quarters.)
HACHURE_INLINE Lanes load_quarters(const float* from, int stride) {
#if HACHURE_LANES == 4
    (void)stride;
    return load_quad(from);
#elif HACHURE_LANES == 8
    return _mm256_insertf128_ps(_mm256_castps128_ps256(load_quad(from)), load_quad(from + stride), 1);
#else
    const __m256 half = _mm256_insertf128_ps(_mm256_castps128_ps256(load_quad(from)), load_quad(from + stride), 1);
    const __m512 most = _mm512_insertf32x4(_mm512_castps256_ps512(half), load_quad(from + 2 * stride), 2);
    return _mm512_insertf32x4(most, load_quad(from + 3 * stride), 3);
#endif
}

HACHURE_INLINE void store_quarters(float* to, int stride, const Lanes& value) {
    const char* bytes = reinterpret_cast<const char*>(&value);
    for (int q = 0; q < quarters; ++q) {
        Quad part;
        __builtin_memcpy(&part, bytes + 16 * q, sizeof part);
        __builtin_memcpy(to + q * stride, &part, sizeof part);
    }
}

/// In each quarter: a[i0], a[i1], b[i2], b[i3].
template <int i0, int i1, int i2, int i3> HACHURE_INLINE Lanes shuffle(const Lanes& a, const Lanes& b) {
    constexpr int n = lane_count;
#if HACHURE_LANES == 4
    return __builtin_shufflevector(a, b, i0, i1, n + i2, n + i3);
#elif HACHURE_LANES == 8
    return __builtin_shufflevector(a, b, i0, i1, n + i2, n + i3, 4 + i0, 4 + i1, n + 4 + i2, n + 4 + i3);
#else
    return __builtin_shufflevector(a, b, i0, i1, n + i2, n + i3, 4 + i0, 4 + i1, n + 4 + i2, n + 4 + i3, 8 + i0, 8 + i1,
                                   n + 8 + i2, n + 8 + i3, 12 + i0, 12 + i1, n + 12 + i2, n + 12 + i3);
#endif
}

/// Four floats of each vertex, at from + vertex * stride, to a vector per element.
HACHURE_INLINE void load4(const float* from, int stride, Lanes (&out)[4]) {
    const Lanes a0 = load_quarters(from, 4 * stride), a1 = load_quarters(from + stride, 4 * stride);
    const Lanes a2 = load_quarters(from + 2 * stride, 4 * stride), a3 = load_quarters(from + 3 * stride, 4 * stride);
    const Lanes t0 = shuffle<0, 1, 0, 1>(a0, a1), t1 = shuffle<2, 3, 2, 3>(a0, a1);
    const Lanes t2 = shuffle<0, 1, 0, 1>(a2, a3), t3 = shuffle<2, 3, 2, 3>(a2, a3);
    out[0] = shuffle<0, 2, 0, 2>(t0, t2);
    out[1] = shuffle<1, 3, 1, 3>(t0, t2);
    out[2] = shuffle<0, 2, 0, 2>(t1, t3);
    out[3] = shuffle<1, 3, 1, 3>(t1, t3);
}

HACHURE_INLINE void store4(float* to, const Lanes (&in)[4]) {
    const Lanes t0 = shuffle<0, 2, 0, 2>(in[0], in[1]), t1 = shuffle<1, 3, 1, 3>(in[0], in[1]);
    const Lanes t2 = shuffle<0, 2, 0, 2>(in[2], in[3]), t3 = shuffle<1, 3, 1, 3>(in[2], in[3]);
    store_quarters(to, 16, shuffle<0, 2, 0, 2>(t0, t2));
    store_quarters(to + 4, 16, shuffle<0, 2, 0, 2>(t1, t3));
    store_quarters(to + 8, 16, shuffle<1, 3, 1, 3>(t0, t2));
    store_quarters(to + 12, 16, shuffle<1, 3, 1, 3>(t1, t3));
}

/// Three floats of each vertex, one vertex after the other, to a vector per element.
HACHURE_INLINE void load3(const float* from, Lanes (&out)[3]) {
    const Lanes a0 = load_quarters(from, 12), a1 = load_quarters(from + 4, 12), a2 = load_quarters(from + 8, 12);
    const Lanes xy = shuffle<2, 3, 1, 2>(a1, a2), yz = shuffle<1, 2, 0, 1>(a0, a1);
    out[0] = shuffle<0, 3, 0, 2>(a0, xy);
    out[1] = shuffle<0, 2, 1, 3>(yz, xy);
    out[2] = shuffle<1, 3, 0, 3>(yz, a2);
}

HACHURE_INLINE void store3(float* to, const Lanes (&in)[3]) {
    const Lanes xy = shuffle<0, 2, 0, 2>(in[0], in[1]), yz = shuffle<1, 3, 1, 3>(in[1], in[2]);
    const Lanes zx = shuffle<0, 2, 1, 3>(in[2], in[0]);
    store_quarters(to, 12, shuffle<0, 2, 0, 2>(xy, zx));
    store_quarters(to + 4, 12, shuffle<0, 2, 1, 3>(yz, xy));
    store_quarters(to + 8, 12, shuffle<1, 3, 1, 3>(zx, yz));
}

HACHURE_INLINE Lanes dot(const Lanes (&a)[3], const Lanes (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

HACHURE_INLINE Lanes least(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
HACHURE_INLINE Lanes greatest(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

/// 1 / sqrt(x) of normal numbers above zero, to the last bit or two: a guess and steps of Newton. The guess is an
/// instruction's 14 bits or, where there is none, comes from the exponent; std::sqrt sets errno, which keeps it out of
/// vectors.
HACHURE_INLINE Lanes inverse_root(const Lanes& x) {
    const Lanes half = 0.5f * x;
#if HACHURE_LANES == 16
    Lanes y = _mm512_maskz_rsqrt14_ps(0xffff, x); // the plain form warns under g++ 12
#else
    const Bits guess = 0x5f375a86 - (reinterpret_cast<Bits>(x) >> 1);
    Lanes y = reinterpret_cast<Lanes>(guess);
    y = y * (1.5f - half * y * y);
    y = y * (1.5f - half * y * y);
#endif
    return y * (1.5f - half * y * y);
}

/// Whether any lane of a comparison's result is set.
HACHURE_INLINE bool any(const Bits& flags) {
    long long words[lane_count / 2];
    __builtin_memcpy(words, &flags, sizeof words);
    long long sum = 0;
    for (const long long word : words) sum |= word;
    return sum != 0;
}
