// What a plugin and its host must have in common.
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <yaml-cpp/yaml.h>

#include "robotui/rt/link/abi.h"
#include "robotui/rt/link/channels.h"
#include "robotui/rt/robot/model_interface.h"
#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {

// Another number means another layout of the interface: a library of another one is refused, with both numbers.
inline constexpr std::uint32_t kPluginAbi = 3;

// Of this source file: internal linkage, so that no other file's list takes its place.
constexpr link::AbiFact kPluginFacts[] = {
    ROBOTUI_RT_TOOLCHAIN_FACTS,
    {"Eigen version", "", EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION, "",
     "with the Eigen of this program."},
    {"Eigen alignment", "", EIGEN_MAX_ALIGN_BYTES, " bytes", "with the same -march, -mavx and EIGEN_MAX_ALIGN_BYTES."},
    ROBOTUI_RT_SIZE_OF(link::FrameData),
    ROBOTUI_RT_SIZE_OF(link::ChannelSegment),
    ROBOTUI_RT_SIZE_OF(config::RobotDescription),
    ROBOTUI_RT_SIZE_OF(Joint),
    ROBOTUI_RT_SIZE_OF(RobotInterface),
    ROBOTUI_RT_SIZE_OF(ModelInterface),
    ROBOTUI_RT_SIZE_OF(YAML::Node),
    {},
};

}  // namespace robotui::rt
