#pragma once

#include <stdexcept>

namespace hachure::gpu {

/// A mistake in how passes are declared or used: it names the pass and the resource. It is our own mistake and not a
/// file's or a driver's; being an exception, tests can read what it says. After one thrown while a frame is declared,
/// only FrameGraph::begin_frame() may follow.
class FrameGraphError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

} // namespace hachure::gpu
