// The framer against the reference over as many streams as one likes. Stream number N of seed S is the same whatever
// the shard and the number of threads; so are the counts.
//
//   framer [--streams N] [--seed S] [--shard I/N] [--jobs N] [--only NUMBER]
//
// Exit code: 0 both always agree, 1 they differ (told as literal bytes with times), 2 bad usage.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/bus/shark/framer_streams.hpp"

namespace {

using reference::Case;

struct Order {
  std::uint64_t streams = 100'000;
  std::uint64_t seed = 1;
  std::uint64_t shard = 1;
  std::uint64_t shards = 1;
  unsigned jobs = 1;
  std::optional<std::uint64_t> only;
};

struct Counts {
  std::uint64_t streams = 0;
  std::uint64_t bytes = 0;
  std::uint64_t spoiled = 0;
  std::uint64_t packets = 0;
  std::uint64_t finished = 0;
  std::uint64_t corrupt = 0;
  std::uint64_t silences = 0;
  std::uint64_t differences = 0;
  std::optional<std::uint64_t> first;  // number of a stream on which they differ

  void add(const Counts& other) {
    streams += other.streams;
    bytes += other.bytes;
    spoiled += other.spoiled;
    packets += other.packets;
    finished += other.finished;
    corrupt += other.corrupt;
    silences += other.silences;
    differences += other.differences;
    if (other.first && (!first || *other.first < *first)) {
      first = other.first;
    }
  }
};

// Far apart, so that neighbouring numbers and seeds share no stream.
std::uint64_t seed_of(std::uint64_t seed, std::uint64_t number) {
  return reference::Dice(seed * 0xD1B54A32D192ED03U + number).roll();
}

void play(const Order& order, std::uint64_t number, Counts& counts) {
  const Case played = reference::make_case(seed_of(order.seed, number));
  if (played.stream.empty()) {
    return;
  }
  ++counts.streams;
  counts.bytes += played.stream.size();
  for (const reference::Byte& byte : played.stream) {
    counts.spoiled += byte.is_spoiled ? 1 : 0;
  }
  const reference::Reading reading(played.stream);
  const reference::ProductRun product(played);
  for (const reference::Outcome& outcome : reading.outcomes()) {
    counts.packets += outcome.packet ? 1 : 0;
    counts.finished += outcome.finished ? 1 : 0;
    counts.corrupt += static_cast<std::uint64_t>(outcome.corrupt);
    counts.silences += outcome.silence ? 1 : 0;
  }
  if (!product.is_sane() || product.outcomes() != reading.outcomes()) {
    ++counts.differences;
    counts.first = counts.first ? counts.first : number;
  }
}

Counts play_all(const Order& order) {
  std::vector<Counts> counts(order.jobs);
  std::vector<std::thread> threads;
  for (unsigned job = 0; job < order.jobs; ++job) {
    threads.emplace_back([&order, &counts, job] {
      Counts own;
      const std::uint64_t step = order.shards * order.jobs;
      for (std::uint64_t i = order.shard - 1 + order.shards * job; i < order.streams; i += step) {
        play(order, i, own);
      }
      counts[job] = own;
    });
  }
  Counts sum;
  for (unsigned job = 0; job < order.jobs; ++job) {
    threads[job].join();
    sum.add(counts[job]);
  }
  return sum;
}

bool read_number(const char* text, std::uint64_t& number) {
  char* end = nullptr;
  number = std::strtoull(text, &end, 10);
  return end != text && *end == 0;
}

bool read_shard(const std::string& text, Order& order) {
  const std::size_t slash = text.find('/');
  return slash != std::string::npos && read_number(text.substr(0, slash).c_str(), order.shard) &&
         read_number(text.substr(slash + 1).c_str(), order.shards) && order.shard >= 1 && order.shard <= order.shards;
}

std::optional<Order> read_order(int argc, char** argv) {
  Order order;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    std::uint64_t number = 0;
    if (word == "--shard") {
      if (!read_shard(argv[i + 1], order)) {
        return std::nullopt;
      }
    } else if (!read_number(argv[i + 1], number)) {
      return std::nullopt;
    } else if (word == "--streams") {
      order.streams = number;
    } else if (word == "--seed") {
      order.seed = number;
    } else if (word == "--only") {
      order.only = number;
    } else if (word == "--jobs" && number >= 1 && number <= 64) {
      order.jobs = static_cast<unsigned>(number);
    } else {
      return std::nullopt;
    }
  }
  return argc % 2 == 1 ? std::optional(order) : std::nullopt;
}

unsigned long long shown(std::uint64_t number) {
  return number;
}

}  // namespace

int main(int argc, char** argv) {
  const auto order = read_order(argc, argv);
  if (!order) {
    std::fputs("usage: framer [--streams N] [--seed S] [--shard I/N] [--jobs N] [--only NUMBER]\n", stderr);
    return 2;
  }
  Counts counts;
  if (order->only) {
    play(*order, *order->only, counts);
  } else {
    counts = play_all(*order);
  }
  if (counts.first) {
    const Case played = reference::make_case(seed_of(order->seed, *counts.first));
    std::printf("stream %llu of seed %llu, made small:\n%s", shown(*counts.first), shown(order->seed),
                reference::tell(reference::shrink(played)).c_str());
  }
  std::printf(
      "framer: seed %llu, shard %llu/%llu: %llu streams, %llu bytes (%llu spoiled): %llu packets, %llu TF, %llu "
      "corrupt, "
      "%llu silences; %llu streams differ\n",
      shown(order->seed), shown(order->shard), shown(order->shards), shown(counts.streams), shown(counts.bytes),
      shown(counts.spoiled), shown(counts.packets), shown(counts.finished), shown(counts.corrupt),
      shown(counts.silences), shown(counts.differences));
  return counts.differences == 0 ? 0 : 1;
}
