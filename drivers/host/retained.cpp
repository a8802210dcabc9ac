#include "drivers/retained.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace retained {

Bytes read() {
  return host::selected().retained;
}

void write(const Bytes& bytes) {
  host::selected().retained = bytes;
}

}  // namespace retained
}  // namespace drivers
