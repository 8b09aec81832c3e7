// The skinning loop, for the instruction set of the including file: included by skin_portable.cpp, skin_avx2.cpp and
// skin_avx512.cpp, each inside a namespace of its own: no include guard, no includes. It calls no inline function of
// other headers: the linker could take that file's copy, with instructions that other machines lack, for all.
//
// A block of as many vertices as there are lanes goes through two steps: blend the palette's entries into vectors that
// hold one element of all its vertices, and do the rest on those vectors. Where the block's vertices share few joints,
// blending goes joint by joint; else vertex by vertex (an entry is a cache line), and the results are turned around.

/// Blended palette entries of a block: 16 floats per vertex.
struct alignas(64) Blended {
    float entry[lane_count][16];
};

/// Affine matrices of a block by rows, a vector per element.
struct Matrices {
    Lanes row[3][4];
};

/// Vertices that share a list of joints: SkinBlocks::size.
constexpr unsigned long shared_stride = 16;
/// Most joints that they share: SkinBlocks::joint_limit.
constexpr unsigned long shared_limit = 12;
/// Most for which going joint by joint is the faster way, measured with blocks of 4 to 32 joints.
constexpr unsigned shared_worthwhile = lane_count == 16 ? 12 : lane_count == 8 ? 8 : 6;

/// One block of a mesh, or a copy of its last vertices filled up to a block.
struct Block {
    const float *rest_positions, *rest_normals, *rest_tangents;
    const void* joints;
    const float* weights;
    const unsigned* shared_joints; ///< of all vertices; their weights are `shared_stride` floats apart
    const float* shared_weights;
    unsigned shared_count; ///< 0 where the block shares none
    float *positions, *normals, *tangents;
};

/// Where the palette entries of a vertex begin. Bytes are loaded four at a time and taken apart: loads are what the
/// loop has most of.
template <class Joint, int influences> HACHURE_INLINE void load_joints(const Joint* joints, long (&entry)[influences]) {
    if constexpr (sizeof(Joint) == 1) {
        for (int k = 0; k < influences; k += 4) {
            unsigned int four;
            __builtin_memcpy(&four, joints + k, sizeof four);
            entry[k] = 16 * static_cast<long>(four & 255u);
            entry[k + 1] = 16 * static_cast<long>(four >> 8 & 255u);
            entry[k + 2] = 16 * static_cast<long>(four >> 16 & 255u);
            entry[k + 3] = 16 * static_cast<long>(four >> 24);
        }
    } else {
        for (int k = 0; k < influences; ++k) entry[k] = 16 * static_cast<long>(joints[k]);
    }
}

/// sum of weight * palette entry; the first 12 floats.
template <class Joint, int influences>
HACHURE_INLINE void blend_matrices(const float* palette, const Joint* joints, const float* weights, Blended& out) {
    for (int v = 0; v < lane_count; ++v, joints += influences, weights += influences) {
#if HACHURE_LANES == 16
        long entry[influences];
        load_joints<Joint, influences>(joints, entry);
        Lanes sum = weights[0] * load(palette + entry[0]);
        for (int k = 1; k < influences; ++k) sum += weights[k] * load(palette + entry[k]);
        store(out.entry[v], sum);
#else
        const float* entry = palette + 16 * static_cast<long>(joints[0]);
        Lanes low = weights[0] * load(entry);
        Quad middle = weights[0] * load_quad(entry + 4), high = weights[0] * load_quad(entry + 8);
        for (int k = 1; k < influences; ++k) {
            entry = palette + 16 * static_cast<long>(joints[k]);
            low += weights[k] * load(entry);
            if (lane_count == 4) middle += weights[k] * load_quad(entry + 4);
            high += weights[k] * load_quad(entry + 8);
        }
        if (lane_count == 4) __builtin_memcpy(out.entry[v] + 4, &middle, sizeof middle);
        store(out.entry[v], low);
        __builtin_memcpy(out.entry[v] + 8, &high, sizeof high);
#endif
    }
}

template <int r> HACHURE_INLINE void add_row(const Lanes& weight, const float* entry, Matrices& sum) {
    sum.row[r][0] += weight * entry[4 * r];
    sum.row[r][1] += weight * entry[4 * r + 1];
    sum.row[r][2] += weight * entry[4 * r + 2];
    sum.row[r][3] += weight * entry[4 * r + 3];
}

template <int r> HACHURE_INLINE void set_row(const Lanes& weight, const float* entry, Matrices& sum) {
    sum.row[r][0] = weight * entry[4 * r];
    sum.row[r][1] = weight * entry[4 * r + 1];
    sum.row[r][2] = weight * entry[4 * r + 2];
    sum.row[r][3] = weight * entry[4 * r + 3];
}

/// Blends the matrices of the joints that a block shares.
HACHURE_INLINE void blend_shared(const float* palette, const Block& block, Matrices& sum) {
    const float* weights = block.shared_weights;
    const float* entry = palette + 16 * static_cast<long>(block.shared_joints[0]);
    Lanes weight = load(weights);
    set_row<0>(weight, entry, sum);
    set_row<1>(weight, entry, sum);
    set_row<2>(weight, entry, sum);
    for (unsigned k = 1; k < block.shared_count; ++k) {
        entry = palette + 16 * static_cast<long>(block.shared_joints[k]);
        weight = load(weights += shared_stride);
        add_row<0>(weight, entry, sum);
        add_row<1>(weight, entry, sum);
        add_row<2>(weight, entry, sum);
    }
}

/// The same for motions; a quaternion that points away from the vertex's first is negated, which is the same rotation
/// on the shorter way (antipodality).
template <class Joint, int influences>
HACHURE_INLINE void blend_motions(const float* palette, const Joint* joints, const float* weights, Blended& out) {
    for (int v = 0; v < lane_count; ++v, joints += influences, weights += influences) {
        const float* entry = palette + 16 * static_cast<long>(joints[0]);
        const Quad first = load_quad(entry);
        Quad sum[4];
        for (int r = 0; r < 4; ++r) sum[r] = weights[0] * load_quad(entry + 4 * r);
        for (int k = 1; k < influences; ++k) {
            entry = palette + 16 * static_cast<long>(joints[k]);
            const Quad real = load_quad(entry), product = real * first;
            const float cosine = product[0] + product[1] + product[2] + product[3];
            const float turned = cosine < 0.0f ? -weights[k] : weights[k];
            sum[0] += turned * real;
            sum[1] += turned * load_quad(entry + 4);
            sum[2] += weights[k] * load_quad(entry + 8);
            sum[3] += weights[k] * load_quad(entry + 12);
        }
        for (int r = 0; r < 4; ++r) __builtin_memcpy(out.entry[v] + 4 * r, &sum[r], sizeof(Quad));
    }
}

HACHURE_INLINE void turn_around(const Blended& blended, Matrices& out) {
    // No loop, here and below: compilers put arrays into registers before they unroll.
    load4(blended.entry[0], 16, out.row[0]);
    load4(blended.entry[0] + 4, 16, out.row[1]);
    load4(blended.entry[0] + 8, 16, out.row[2]);
}

/// The matrix of a blended motion: rotation * stretch, and the translation 2 * dual * conjugate(real).
HACHURE_INLINE void motions_to_matrices(const Blended& blended, Matrices& out) {
    Lanes q[4], d[4], diagonal[4], mixed[4];
    load4(blended.entry[0], 16, q);
    load4(blended.entry[0] + 4, 16, d);
    load4(blended.entry[0] + 8, 16, diagonal);
    load4(blended.entry[0] + 12, 16, mixed);
    // The first weight is at least 1/8 and the others point its way, so the length is never near zero.
    const Lanes inverse = inverse_root(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; ++i) {
        q[i] *= inverse;
        d[i] *= inverse;
    }
    const Lanes x = q[0], y = q[1], z = q[2], w = q[3];
    const Lanes rotation[3][3] = {
        {1.0f - 2.0f * (y * y + z * z), 2.0f * (x * y - w * z), 2.0f * (x * z + w * y)},
        {2.0f * (x * y + w * z), 1.0f - 2.0f * (x * x + z * z), 2.0f * (y * z - w * x)},
        {2.0f * (x * z - w * y), 2.0f * (y * z + w * x), 1.0f - 2.0f * (x * x + y * y)},
    };
    const Lanes stretch[3][3] = {
        {diagonal[0], mixed[0], mixed[1]}, {mixed[0], diagonal[1], mixed[2]}, {mixed[1], mixed[2], diagonal[2]}};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out.row[r][c] =
                rotation[r][0] * stretch[0][c] + rotation[r][1] * stretch[1][c] + rotation[r][2] * stretch[2][c];
    out.row[0][3] = 2.0f * (w * d[0] - d[3] * x + y * d[2] - z * d[1]);
    out.row[1][3] = 2.0f * (w * d[1] - d[3] * y + z * d[0] - x * d[2]);
    out.row[2][3] = 2.0f * (w * d[2] - d[3] * z + x * d[1] - y * d[0]);
}

/// Matrices of a block element by element, for the few vertices that need care.
struct Scattered {
    float matrix[lane_count][12];
};

[[gnu::noinline, gnu::cold]] void scatter(const Matrices& m, Scattered& out) {
    for (int e = 0; e < 12; ++e) {
        float element[lane_count];
        store(element, m.row[e / 4][e % 4]);
        for (int v = 0; v < lane_count; ++v) out.matrix[v][e] = element[v];
    }
}

[[gnu::noinline, gnu::cold]] void care_for_normals(const Matrices& m, const Bits& bad, const Block& block) {
    Scattered scattered;
    scatter(m, scattered);
    for (int v = 0; v < lane_count; ++v)
        if (bad[v]) careful_normal(scattered.matrix[v], block.rest_normals + 3 * v, block.normals + 3 * v);
}

[[gnu::noinline, gnu::cold]] void care_for_tangents(const Matrices& m, const Bits& bad, const Block& block) {
    Scattered scattered;
    scatter(m, scattered);
    for (int v = 0; v < lane_count; ++v)
        if (bad[v])
            careful_tangent(scattered.matrix[v], block.rest_tangents + 4 * v, block.normals + 3 * v,
                            block.tangents + 4 * v);
}

template <int r>
HACHURE_INLINE void transform_coordinate(const Matrices& m, const Lanes (&p)[3], Lanes (&out)[3], Lanes (&low)[3],
                                         Lanes (&high)[3]) {
    out[r] = m.row[r][0] * p[0] + m.row[r][1] * p[1] + m.row[r][2] * p[2] + m.row[r][3];
    low[r] = least(low[r], out[r]);
    high[r] = greatest(high[r], out[r]);
}

/// Transforms positions; widens the bounds.
HACHURE_INLINE void transform_positions(const Matrices& m, const Block& block, Lanes (&low)[3], Lanes (&high)[3]) {
    Lanes p[3], out[3];
    load3(block.rest_positions, p);
    transform_coordinate<0>(m, p, out, low, high);
    transform_coordinate<1>(m, p, out, low, high);
    transform_coordinate<2>(m, p, out, low, high);
    store3(block.positions, out);
}

/// Row r of the cofactors times the normal; widens what the matrix's size is.
template <int r>
HACHURE_INLINE void transform_cofactors(const Matrices& m, const Lanes (&n)[3], Lanes (&out)[3], Lanes& size) {
    const Lanes(&a)[4] = m.row[(r + 1) % 3], (&b)[4] = m.row[(r + 2) % 3];
    out[r] =
        (a[1] * b[2] - a[2] * b[1]) * n[0] + (a[2] * b[0] - a[0] * b[2]) * n[1] + (a[0] * b[1] - a[1] * b[0]) * n[2];
    size += m.row[r][0] * m.row[r][0] + m.row[r][1] * m.row[r][1] + m.row[r][2] * m.row[r][2];
}

/// Transforms normals by the cofactors, which stay where the matrix flattens, and turns them outwards again where it
/// mirrors; returns which lanes do.
HACHURE_INLINE Bits transform_normals(const Matrices& m, const Lanes (&n)[3], const Block& block, Lanes (&unit)[3]) {
    Lanes out[3], size = all(0.0f);
    transform_cofactors<0>(m, n, out, size);
    transform_cofactors<1>(m, n, out, size);
    transform_cofactors<2>(m, n, out, size);
    const Lanes(&a)[4] = m.row[1], (&b)[4] = m.row[2];
    const Lanes determinant = m.row[0][0] * (a[1] * b[2] - a[2] * b[1]) + m.row[0][1] * (a[2] * b[0] - a[0] * b[2]) +
                              m.row[0][2] * (a[0] * b[1] - a[1] * b[0]);
    const Lanes square = dot(out, out);
    // Shorter than 1e-6 of what such a matrix gives is what rounding leaves of a collapse; the rest is out of float's
    // comfortable range.
    const Bits good = (square > 1e-12f * size * size) & (square > all(1e-30f)) & (square < all(1e30f));
    const Lanes inverse = inverse_root(square);
    // The stretch along the normal. Where it is nothing but rounding, its sign says nothing.
    const Lanes along = determinant * inverse;
    const Bits mirrors = (along < all(0.0f)) & (along * along > 1e-12f * size);
    const Lanes outwards = mirrors ? -inverse : inverse;
    unit[0] = out[0] * outwards;
    unit[1] = out[1] * outwards;
    unit[2] = out[2] * outwards;
    store3(block.normals, unit);
    if (any(~good)) [[unlikely]] {
        const Matrices copy = m; // one whose address nobody takes stays in registers
        care_for_normals(copy, ~good, block);
        load3(block.normals, unit);
    }
    return mirrors;
}

/// Transforms tangents and takes the part perpendicular to the normal; turns w where the matrix mirrors.
HACHURE_INLINE void transform_tangents(const Matrices& m, const Block& block, const Lanes (&normal)[3],
                                       const Bits& mirrors) {
    Lanes t[4], out[4], moved[3];
    load4(block.rest_tangents, 4, t);
    for (int r = 0; r < 3; ++r) moved[r] = m.row[r][0] * t[0] + m.row[r][1] * t[1] + m.row[r][2] * t[2];
    const Lanes before = dot(moved, moved), along = dot(moved, normal);
    for (int r = 0; r < 3; ++r) moved[r] -= along * normal[r];
    const Lanes square = dot(moved, moved);
    const Bits good = (square > 1e-6f * before) & (square > all(1e-30f)) & (square < all(1e30f));
    const Lanes inverse = inverse_root(square);
    for (int r = 0; r < 3; ++r) out[r] = moved[r] * inverse;
    out[3] = mirrors ? -t[3] : t[3];
    store4(block.tangents, out);
    if (any(~good)) [[unlikely]] {
        const Matrices copy = m;
        care_for_tangents(copy, ~good, block);
    }
}

/// A block of which a range holds some vertices, [low, high): the other lanes repeat the nearest of these.
template <class Joint, int influences> struct Part {
    int low, high;
    float rest_positions[3 * lane_count], rest_normals[3 * lane_count], rest_tangents[4 * lane_count];
    Joint joints[influences * lane_count];
    float weights[influences * lane_count], shared_weights[shared_stride * shared_limit];
    float positions[3 * lane_count], normals[3 * lane_count], tangents[4 * lane_count];

    template <class T> void copy(const T* from, int size, T* to) const {
        for (int v = 0; from && v < lane_count; ++v) {
            const int nearest = v < low ? low : v < high ? v : high - 1;
            for (int i = 0; i < size; ++i) to[v * size + i] = from[nearest * size + i];
        }
    }

    void copy_back(const float* from, int size, float* to) const {
        for (int i = size * low; to && i < size * high; ++i) to[i] = from[i];
    }

    [[gnu::noinline]] Block take(const Block& block) {
        copy(block.rest_positions, 3, rest_positions);
        copy(block.rest_normals, 3, rest_normals);
        copy(block.rest_tangents, 4, rest_tangents);
        copy(static_cast<const Joint*>(block.joints), influences, joints);
        copy(block.weights, influences, weights);
        for (unsigned k = 0; k < block.shared_count; ++k)
            copy(block.shared_weights + k * shared_stride, 1, shared_weights + k * shared_stride);
        Block own = block;
        own.rest_positions = rest_positions;
        own.rest_normals = rest_normals;
        own.rest_tangents = rest_tangents;
        own.joints = joints;
        own.weights = weights;
        own.shared_weights = shared_weights;
        own.positions = positions;
        own.normals = block.normals ? normals : nullptr;
        own.tangents = block.tangents ? tangents : nullptr;
        return own;
    }

    [[gnu::noinline]] void give_back(const Block& block) const {
        copy_back(positions, 3, block.positions);
        copy_back(normals, 3, block.normals);
        copy_back(tangents, 4, block.tangents);
    }
};

/// The block that begins with vertex `first`, a multiple of the lanes.
HACHURE_INLINE Block block_at(const Arguments& arguments, unsigned long first, unsigned long joint_bytes,
                              unsigned long influences) {
    const unsigned* shared = arguments.block_firsts + first / shared_stride;
    return {arguments.rest_positions + 3 * first,
            arguments.rest_normals ? arguments.rest_normals + 3 * first : nullptr,
            arguments.rest_tangents ? arguments.rest_tangents + 4 * first : nullptr,
            static_cast<const char*>(arguments.joints) + first * influences * joint_bytes,
            arguments.weights + first * influences,
            arguments.block_joints + shared[0],
            arguments.block_weights ? arguments.block_weights + shared[0] * shared_stride + first % shared_stride
                                    : nullptr,
            shared[1] - shared[0],
            arguments.positions + 3 * first,
            arguments.normals ? arguments.normals + 3 * first : nullptr,
            arguments.tangents ? arguments.tangents + 4 * first : nullptr};
}

/// Bounds so far, lane by lane.
struct Box {
    Lanes low[3], high[3];
};

/// Puts the bounds of the lanes together.
void join_bounds(const Box& box, Arguments& arguments) {
    for (int r = 0; r < 3; ++r)
        for (int v = 0; v < lane_count; ++v) {
            const float low = box.low[r][v], high = box.high[r][v];
            arguments.low[r] = low < arguments.low[r] ? low : arguments.low[r];
            arguments.high[r] = high > arguments.high[r] ? high : arguments.high[r];
        }
}

/// Never inlined, so that the first and last vertices of a range take the same instructions as all others: results to
/// the bit do not depend on ranges.
template <bool dual_quaternion, class Joint, int influences>
[[gnu::noinline]] void run_block(const float* palette, const Block& block, Box& box) {
    Matrices matrices;
    const auto* joints = static_cast<const Joint*>(block.joints);
    if constexpr (dual_quaternion) {
        Blended blended;
        blend_motions<Joint, influences>(palette, joints, block.weights, blended);
        motions_to_matrices(blended, matrices);
    } else if (block.shared_count > 0 && block.shared_count <= shared_worthwhile) {
        blend_shared(palette, block, matrices);
    } else {
        Blended blended;
        blend_matrices<Joint, influences>(palette, joints, block.weights, blended);
        turn_around(blended, matrices);
    }
    if (!block.normals) return transform_positions(matrices, block, box.low, box.high);
    // Arrays of one size often begin at one place within a page; what is read after a write there waits for it.
    Lanes rest[3], normal[3];
    load3(block.rest_normals, rest);
    transform_positions(matrices, block, box.low, box.high);
    const Bits mirrors = transform_normals(matrices, rest, block, normal);
    if (block.tangents) transform_tangents(matrices, block, normal, mirrors);
}

template <bool dual_quaternion, class Joint, int influences> void run_loop(Arguments& arguments) {
    Box box;
    for (int r = 0; r < 3; ++r) {
        box.low[r] = all(arguments.low[r]);
        box.high[r] = all(arguments.high[r]);
    }
    // Blocks begin at multiples of the lanes wherever the range does: a vertex's neighbours share its joints, and its
    // lane is always the same.
    for (unsigned long first = arguments.first - arguments.first % lane_count; first < arguments.end;
         first += lane_count) {
        const Block block = block_at(arguments, first, sizeof(Joint), influences);
        if (first >= arguments.first && first + lane_count <= arguments.end) {
            run_block<dual_quaternion, Joint, influences>(arguments.palette, block, box);
        } else {
            Part<Joint, influences> part;
            part.low = first < arguments.first ? static_cast<int>(arguments.first - first) : 0;
            part.high = first + lane_count > arguments.end ? static_cast<int>(arguments.end - first) : lane_count;
            run_block<dual_quaternion, Joint, influences>(arguments.palette, part.take(block), box);
            part.give_back(block);
        }
    }
    join_bounds(box, arguments);
}

template <bool dual_quaternion, class Joint> Loop choose_influences(bool eight) {
    return eight ? &run_loop<dual_quaternion, Joint, 8> : &run_loop<dual_quaternion, Joint, 4>;
}

template <bool dual_quaternion> Loop choose_joint(const Variant& variant) {
    if (variant.joint_bytes == 1) return choose_influences<dual_quaternion, unsigned char>(variant.eight);
    if (variant.joint_bytes == 2) return choose_influences<dual_quaternion, unsigned short>(variant.eight);
    return choose_influences<dual_quaternion, unsigned int>(variant.eight);
}

Loop choose_loop(const Variant& variant) {
    return variant.dual_quaternion ? choose_joint<true>(variant) : choose_joint<false>(variant);
}
