#pragma once
namespace nav2_costmap_2d {static constexpr unsigned char LETHAL_OBSTACLE = 254;}
