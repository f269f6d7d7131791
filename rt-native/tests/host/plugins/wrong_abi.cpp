#include <cstdint>

extern "C" __attribute__((visibility("default"))) std::uint32_t robotui_rt_plugin_abi() { return 999; }
