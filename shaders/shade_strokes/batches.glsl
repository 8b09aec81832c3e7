// Segments are drawn in batches of about as many strokes, one command each: a batch has room for as many strokes as its
// size says, what a segment does not need of it is empty.

const int SIZES = 17;
const int BATCHES = 2 * SIZES; // of straight strokes, then of bent ones
const int MOST_STROKES = 384;
const int GROUP = 64; // segments that are counted together

// 1, 2, 3, 4, 6, 8, 12, ... 256, 384.
int batch_size(int i) { return i == 0 ? 1 : (i & 1) == 1 ? 2 << ((i - 1) / 2) : 3 << ((i - 2) / 2); }

int batch_of(int strokes) {
    int i = 0;
    while (i + 1 < SIZES && batch_size(i) < strokes) ++i;
    return i;
}
