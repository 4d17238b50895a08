#include "core/study/trial_order.h"

#include <limits>
#include <numeric>

namespace tactum {

namespace {

/// Spreads close seeds apart (splitmix64 by Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

StudyTrial trialOf(std::initializer_list<int> conditions) {
    StudyTrial trial;
    for (const int condition : conditions)
        trial.intervals.push_back({condition, {}});
    return trial;
}

std::vector<int> listed(int count) {
    std::vector<int> all(std::size_t(count), 0);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<StudyTrial> listOf(const StudyDesign& design, int participant, StudyRandom& random) {
    const int count = int(design.conditions.size());
    std::vector<StudyTrial> trials;
    for (int repeat = 0; repeat < design.repeats; ++repeat) {
        std::vector<int> order =
            design.order == StudyOrder::Balanced ? latinRow(count, participant - 1 + repeat) : listed(count);
        if (design.order == StudyOrder::Random) random.shuffle(std::span(order));
        for (const int condition : order)
            trials.push_back(trialOf({condition}));
    }
    return trials;
}

/// Ways to show a pair; each way equally often, as far as the repetitions go, and in an order that nobody can
/// guess.
std::vector<int> ways(int count, int repeats, StudyRandom& random) {
    std::vector<int> all;
    while (int(all.size()) < repeats) {
        std::vector<int> block = listed(count);
        random.shuffle(std::span(block));
        all.insert(all.end(), block.begin(), block.end());
    }
    all.resize(std::size_t(repeats));
    random.shuffle(std::span(all));
    return all;
}

StudyTrial pairOf(int a, int b, bool swapped) {
    return swapped ? trialOf({b, a}) : trialOf({a, b});
}

StudyTrial abxOf(int a, int b, int way) {
    StudyTrial trial = pairOf(a, b, way & 1);
    trial.right = way >> 1;
    trial.intervals.push_back(trial.intervals[std::size_t(*trial.right)]);
    return trial;
}

std::vector<StudyTrial> pairsFor(const StudyDesign& design, StudyRandom& random) {
    const bool abx = design.procedure == Procedure::Abx;
    const int count = int(design.conditions.size());
    std::vector<std::vector<StudyTrial>> blocks{std::size_t(design.repeats)};
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            const std::vector<int> way = ways(abx ? 4 : 2, design.repeats, random);
            for (std::size_t i = 0; i < blocks.size(); ++i)
                blocks[i].push_back(abx ? abxOf(a, b, way[i])
                                        : pairOf(a, b, design.order == StudyOrder::Random && way[i] == 1));
        }
    std::vector<StudyTrial> trials;
    for (std::vector<StudyTrial>& block : blocks) {
        if (design.order == StudyOrder::Random) random.shuffle(std::span(block));
        trials.insert(trials.end(), block.begin(), block.end());
    }
    return trials;
}

} // namespace

StudyRandom::StudyRandom(std::uint64_t seed, int participant)
    : engine_(mixed(mixed(seed) + std::uint64_t(participant))) {}

int StudyRandom::below(int count) {
    // What is left over at the end would make the small numbers likelier.
    const std::uint64_t most = std::numeric_limits<std::uint64_t>::max(), wide = std::uint64_t(count);
    std::uint64_t drawn = engine_();
    while (drawn >= most - most % wide)
        drawn = engine_();
    return int(drawn % wide);
}

std::vector<int> latinRow(int count, int row) {
    const bool mirrored = count % 2 == 1 && row / count % 2 == 1;
    std::vector<int> order;
    for (int place = 0; place < count; ++place) {
        const int first =
            place % 2 == 1 ? (place + 1) / 2 : (count - place / 2) % count; // 0, 1, n-1, 2, n-2 ...
        order.push_back((first + row) % count);
    }
    if (mirrored) std::reverse(order.begin(), order.end());
    return order;
}

std::vector<StudyTrial> trialsFor(const StudyDesign& design, int participant, std::uint64_t seed) {
    StudyRandom random(seed, participant);
    return design.procedure == Procedure::List ? listOf(design, participant, random)
                                               : pairsFor(design, random);
}

} // namespace tactum
