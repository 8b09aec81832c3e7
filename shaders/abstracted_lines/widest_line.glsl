// Widths are stored as parts of it, px, as formats between 0 and 1 need; systems/abstracted_lines/tone_line_style.h has the
// same.
const float widest_line = 64.0;
