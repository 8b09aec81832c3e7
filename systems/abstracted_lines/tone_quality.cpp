#include <hachure/systems/abstracted_lines/tone_quality.h>

namespace hachure {

ToneImage resolved(const ToneImage& wanted) {
    ToneImage made = wanted;
    switch (wanted.quality) {
    case ToneQuality::custom:
        break;
    case ToneQuality::standard:
        made = {};
        break;
    case ToneQuality::fast:
        made = {.taps = ToneTaps::square, .iterations = 4};
        break;
    case ToneQuality::accurate:
        made = {.samples = 4, .taps = ToneTaps::wide, .iterations = 8};
        break;
    }
    made.quality = ToneQuality::custom;
    return made;
}

gpu::Format tone_format(ToneStorage storage, bool widths) {
    switch (storage) {
    case ToneStorage::rg8:
        return widths ? gpu::Format::rgba16 : gpu::Format::rg8; // widths need more than 8 bits
    case ToneStorage::rg16f:
        return widths ? gpu::Format::rgba16f : gpu::Format::rg16f;
    case ToneStorage::rg32f:
        return widths ? gpu::Format::rgba32f : gpu::Format::rg32f;
    case ToneStorage::rg16:
        break;
    }
    return widths ? gpu::Format::rgba16 : gpu::Format::rg16;
}

} // namespace hachure
