#pragma once
namespace hardware_interface {constexpr char HW_IF_POSITION[] = "position";}
