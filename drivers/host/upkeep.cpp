#include "drivers/upkeep.hpp"

namespace drivers {
namespace upkeep {

void refresh() {}

}  // namespace upkeep
}  // namespace drivers
