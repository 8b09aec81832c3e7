#pragma once

#include <hachure/runtime/gpu/context.h>

#include <iosfwd>

namespace hachure::bench {

/// Error of features against time, on the ripple as a relief of 256 x 256: rows panel,series,label,x,y for the panels
/// `window` (of profiles, px), `taps` (k, by number of fits, with the qualities as series `preset`), `diffusion`
/// (steps, by noise of the slopes) and `storage`. x: ms of a megapixel, of the steps that the knob changes; y: how far
/// lines are from where they should be, RMS px, or `nan` where nothing was found.
void write_feature_rows(std::ostream& file, gpu::Context& context, bool quick);

} // namespace hachure::bench
