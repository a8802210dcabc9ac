// The numbers of a run, for the end of the story.
#pragma once

#include <string>

#include "simulation/report/story.hpp"
#include "simulation/report/transcript.hpp"

namespace simulation::report {

// Several lines, aligned. The world must not have changed since the run's end.
std::string make_table(const Story& story, const Transcript& transcript, World& world);

}  // namespace simulation::report
