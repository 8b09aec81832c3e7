// Shared by every shader: nothing else than names and constants.
const float PI = 3.14159265358979323846;
