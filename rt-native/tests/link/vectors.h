// Pieces of shared memory with known values, as files that every language reads: tests/vectors.
#pragma once

#include <memory>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

std::unique_ptr<StateFrame> stateFrameVector();
std::unique_ptr<HostSegment> hostSegmentVector();
std::unique_ptr<BoardSegment> boardVector();

}  // namespace robotui::rt::link
