// Of a threshold of curvature that a fit beside a line has to see: at the rim of a bar it is a quarter of the curvature
// of its middle.
const float rim_part = 0.25;
