// Of a threshold of curvature that a fit beside a line has to see. At the rim of a bar it sees .28 of the curvature of its
// middle: all of a line is found from 1.4 times the threshold on, where it begins to show. Each tenth less is a tenth
// more of the search.
const float rim_part = 0.4;
