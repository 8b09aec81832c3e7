#pragma once

#include <hachure/runtime/assets/model.h>

/// A tentacle of two metres on four joints, with the clips "wave" and "curl": what the sample shows without a file.
hachure::assets::Model make_tentacle();
