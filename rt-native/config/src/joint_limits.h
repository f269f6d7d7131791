// The block JointLimits: what a configuration says of how fast joints may be told to move, beside their URDF.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "robotui/rt/config/reader.h"
#include "urdf.h"

namespace robotui::rt::config {

class JointLimits {
 public:
  JointLimits() = default;  // says nothing

  // Throws ConfigError.
  explicit JointLimits(const Reader& block);

  // The joint with its limits made narrower, or given where the URDF has none. Throws ConfigError where an entry of the
  // joint itself is wider than the URDF.
  UrdfJoint appliedTo(UrdfJoint joint) const;

  // Throws ConfigError where one of the names is no joint of the map.
  void mustName(const std::vector<JointDescription>& joints) const;

 private:
  std::optional<Reader> all_;
  std::map<std::string, Reader> joints_;
};

}  // namespace robotui::rt::config
