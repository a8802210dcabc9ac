// Settings at the ends of their ranges, where sums are largest.
#pragma once

#include "spm/settings.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

// Each setting at its least, its most or its default.
spm::Settings any_extremes(Random& random);

}  // namespace vectors
