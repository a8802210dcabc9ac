// "Did you mean": the known word nearest to what was written.
#pragma once

#include <string>
#include <vector>

namespace simulation::scenario {

// Number of letters to insert, drop, change or swap.
std::size_t edit_distance(const std::string& one, const std::string& other);

// " (did you mean 'expect'?)", or, when nothing is near, the list of what is known: " (known: a, b, c)".
std::string suggest(const std::string& word, const std::vector<std::string>& known);

}  // namespace simulation::scenario
