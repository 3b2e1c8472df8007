#pragma once
namespace nav2_costmap_2d {class Costmap2DROS {};}
