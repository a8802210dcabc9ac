// The scenario language in one text, made from the tables that read it.
#pragma once

#include <string>

namespace simulation::scenario {

std::string tell_lexicon();

}  // namespace simulation::scenario
