#include "simulation/bench/json.hpp"

#include <nlohmann/json.hpp>

namespace simulation::bench {
namespace {

using Json = nlohmann::ordered_json;

Json show(const Spread& spread) {
  return {{"count", spread.count}, {"min", spread.least}, {"median", spread.median}, {"max", spread.most}};
}

Json show(const TurnFigures& turn) {
  return {{"us", show(turn.length)}, {"bytes", show(turn.bytes)}};
}

Json show(const PlacedSpan& span) {
  return {{"cycles", span.cycles}, {"from", span.place}};
}

template <typename Value>
Json show(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json show(const RunFigures& run) {
  Json interrupts = Json::object();
  for (const InterruptFigures& row : run.interrupts) {
    interrupts[row.name] = {{"count", row.count},
                            {"per_second", row.per_second},
                            {"mean_cycles", row.mean_cycles},
                            {"longest_cycles", row.longest_cycles}};
  }
  return {{"seconds", run.seconds},
          {"answer_us", show(run.answer)},
          {"idle_inside_turn_us", show(run.pause)},
          {"sr_turn", show(run.sr)},
          {"spm_turn", show(run.spm)},
          {"sacu_turn", show(run.sacu)},
          {"last_turn_ends_us", show(run.end_of_talk)},
          {"cycles", run.cycles},
          {"broken_cycles", run.broken_cycles},
          {"utilisation", show(run.utilisation)},
          {"cpu_load", run.load},
          {"cpu_load_per_cycle", show(run.load_per_cycle)},
          {"interrupts", interrupts},
          {"interrupts_off",
           {{"by_program", show(run.locked)}, {"with_handlers", show(run.off)}, {"at_start", show(run.off_at_start)}}},
          {"lost",
           {{"overruns", run.losses.overruns},
            {"spoiled", run.losses.spoiled},
            {"unanswered", run.losses.missed},
            {"corrupt", run.losses.corrupt},
            {"characters", run.losses.unreturned}}},
          {"programmer_characters", run.characters},
          {"stack_bytes", show(run.stack_used)},
          {"complaints", run.complaints}};
}

Json show(const NoiseFigures& run) {
  return {{"name", run.name},
          {"seconds", run.seconds},
          {"cpu_load", run.load},
          {"cpu_load_per_cycle", show(run.load_per_cycle)},
          {"ticks", run.ticks},
          {"answer_us", show(run.answer)},
          {"characters_said", run.characters_said},
          {"stop_begins_ms", show(run.stop_begins_ms)},
          {"stop_lasts_ms", show(run.stop_lasts_ms)},
          {"interrupts_off_cycles", run.off},
          {"longest_interrupt_cycles", run.longest_interrupt},
          {"overruns", run.overruns}};
}

}  // namespace

std::string tell_json(const Figures& figures, const std::vector<Target>& targets) {
  Json examples = Json::array();
  for (const Example& example : figures.examples) {
    examples.push_back({{"name", example.name},
                        {"bytes", example.sr_bytes + example.spm_bytes + example.sacu_bytes},
                        {"computed_us", example.computed_us},
                        {"back_to_back_us", example.back_to_back_us},
                        {"measured_us", show(example.measured_us)}});
  }
  Json noise = Json::array();
  for (const NoiseFigures& run : figures.noise) {
    noise.push_back(show(run));
  }
  Json missed = Json::array();
  for (const Target& target : targets) {
    if (!target.is_met) {
      missed.push_back({{"what", target.what}, {"wanted", target.wanted}, {"seen", target.seen}});
    }
  }
  const Json all{{"image",
                  {{"name", figures.image.name},
                   {"compiler", figures.image.compiler},
                   {"flash", figures.image.flash},
                   {"static_ram", show(figures.image.static_ram)},
                   {"stack_bound", show(figures.image.stack_bound)}}},
                 {"idle", show(figures.idle)},
                 {"heaviest", show(figures.heavy)},
                 {"noise", noise},
                 {"utilisation_examples", examples},
                 {"missed_targets", missed}};
  return all.dump(2) + "\n";
}

}  // namespace simulation::bench
