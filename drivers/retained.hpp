// A few bytes of RAM that a reset leaves as they are. A new supply leaves anything in them, and so may a brown-out: who
// keeps something here must be able to tell (H-25).
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"

namespace drivers {
namespace retained {

using Bytes = base::Array<uint8_t, 4>;

Bytes read();
void write(const Bytes& bytes);

}  // namespace retained
}  // namespace drivers
