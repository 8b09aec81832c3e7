#pragma once

#include <hachure/runtime/assets/model.h>

/// What the sample shows without a file: a flange with its hub, screws and holes, and on its shaft a gear and a fluted
/// knob. A node each, so that each turns about its own Y axis; about 2 m across.
hachure::assets::Model make_part();
