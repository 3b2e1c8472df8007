#pragma once

namespace standin
{
template<typename Derived, typename Base>
struct Exported
{
  Base * make() {return new Derived;}
};
}  // namespace standin

#define PLUGINLIB_EXPORT_CLASS(Derived, Base) template struct standin::Exported<Derived, Base>;
