#pragma once

#include <string>
#include <vector>

namespace hardware_interface
{
struct ComponentInfo {std::string name;};
struct HardwareInfo {std::vector<ComponentInfo> joints;};
}  // namespace hardware_interface
