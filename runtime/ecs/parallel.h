#pragma once
#include <cstddef>
#include <functional>
namespace hachure {
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);
}
