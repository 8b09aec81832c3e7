// Rows of marked pixels (marks.frag).

layout(binding = 2) uniform usampler2D marks;

// The marks of a texel that belong to pixels of columns `from` to `to`.
uint marks_within(int column, int row, int from, int to) {
    uint bits = texelFetch(marks, ivec2(column, row), 0).r;
    int low = from - 32 * column, high = to - 32 * column;
    if (low > 0) bits &= 0xffffffffu << low;
    if (high < 31) bits &= 0x7fffffffu >> (30 - high);
    return bits;
}
