// The estimators, each a closed form or a least-squares fit.
#include "core/self_test/identify.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace tactum {
namespace {

constexpr int kSmooth = 9;         ///< ticks to each side of a mean, taken three times
constexpr double kLongest = 0.03;  ///< s, of the delays that are tried
constexpr int kTrials = 121;       ///< of them
constexpr int kSmoothSign = 2;     ///< the same for which way it moves, which changes at once
constexpr double kStill = 0.01;    ///< m/s: slower, and dry friction may be anything
constexpr double kMostStill = 0.2; ///< of the time about a row that is used
constexpr double kMoves = 1e-4;    ///< m, rms, that an axis has to move

using Series = Eigen::VectorXd;

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A mean over neighbours, three times: nearly a bell, without a lag. What lies within reach of the ends is
/// not used later.
Series smooth(const Series& values, int side = kSmooth) {
    Series now = values;
    for (int pass = 0; pass < 3; ++pass) {
        Series next = now;
        for (Eigen::Index i = side; i + side < now.size(); ++i)
            next[i] = now.segment(i - side, 2 * side + 1).mean();
        now = next;
    }
    return now;
}

Series slope(const Series& values, double dt) {
    Series rise = Series::Zero(values.size());
    for (Eigen::Index i = 1; i + 1 < values.size(); ++i)
        rise[i] = (values[i + 1] - values[i - 1]) / (2 * dt);
    return rise;
}

/// The force of so many s before, between two ticks linearly.
Series late(const Series& force, double delay, double dt) {
    Series shifted = Series::Zero(force.size());
    const double ticks = delay / dt;
    const auto whole = Eigen::Index(ticks);
    const double part = ticks - double(whole);
    for (Eigen::Index i = whole + 1; i < force.size(); ++i)
        shifted[i] = (1 - part) * force[i - whole] + part * force[i - whole - 1];
    return shifted;
}

/// Place and command at even times: a busy machine ticks when it can, and a reading may come once more.
struct Even {
    Series place, force;
    double dt = 0; ///< s
};

Even evenly(std::span<const TrialRow> rows, int axis) {
    const auto count = Eigen::Index(rows.size());
    const double begin = rows.front().time, dt = (rows.back().time - begin) / double(count - 1);
    Even even{Series(count), Series(count), dt};
    const TrialRow* before = &rows.front();
    std::size_t next = 0, command = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double time = begin + dt * double(i);
        while (command + 1 < rows.size() && rows[command + 1].time <= time + 1e-9)
            ++command;
        for (; next + 1 < rows.size() && (!rows[next].valid || rows[next].time < time); ++next)
            if (rows[next].valid) before = &rows[next];
        const TrialRow& after = rows[next];
        const double apart = after.time - before->time;
        const double part = apart > 0 ? std::clamp((time - before->time) / apart, 0.0, 1.0) : 0;
        even.place[i] = (1 - part) * before->position[axis] + part * after.position[axis];
        even.force[i] = rows[command].force[axis];
    }
    return even;
}

struct Fit {
    Eigen::VectorXd values, errors;
    double remainder = 0; ///< rms, N
};

Fit fit(const Eigen::MatrixXd& sides, const Series& force) {
    const Eigen::MatrixXd normal = sides.transpose() * sides;
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    Fit found;
    found.values = solver.solve(sides.transpose() * force);
    const double squares = (force - sides * found.values).squaredNorm();
    found.remainder = std::sqrt(squares / double(force.size()));
    // Neighbours were smoothed together: only one in so many rows says something new.
    constexpr double kTogether = 2 * kSmooth + 1;
    const double free = std::max(1.0, double(force.size()) / kTogether - double(sides.cols()));
    const Eigen::VectorXd spread =
        solver.solve(Eigen::MatrixXd::Identity(sides.cols(), sides.cols())).diagonal();
    found.errors = (spread * squares / free).cwiseSqrt();
    return found;
}

/// No friction pushes: where that comes out there is none, and damping is what is left. Sides: a, v, sgn
/// v, 1.
Fit fitAxis(const Eigen::MatrixXd& sides, const Series& force) {
    Fit found = fit(sides, force);
    if (found.values[2] >= 0) return found;
    const double error = found.errors[2];
    Eigen::MatrixXd fewer(sides.rows(), 3);
    fewer << sides.col(0), sides.col(1), sides.col(3);
    found = fit(fewer, force);
    found.values = Eigen::Vector4d(found.values[0], found.values[1], 0, found.values[2]);
    found.errors = Eigen::Vector4d(found.errors[0], found.errors[1], error, found.errors[2]);
    return found;
}

} // namespace

Pace paceOf(std::span<const TrialRow> rows) {
    std::vector<double> between;
    double last = -1;
    for (const TrialRow& row : rows) {
        if (!row.valid) continue;
        if (last >= 0) between.push_back(row.time - last);
        last = row.time;
    }
    if (between.empty()) return {};
    const double sum = std::accumulate(between.begin(), between.end(), 0.0);
    return {double(between.size()) / sum, medianOf(between), *std::ranges::max_element(between)};
}

// The line that fits best goes through the middle: its slope is all that is left to find.
double noiseOf(std::span<const TrialRow> rows) {
    if (rows.size() < 3) return 0;
    const Vec3 middle = middleOf(rows);
    double when = 0;
    for (const TrialRow& row : rows)
        when += row.time / double(rows.size());
    Vec3 along = Vec3::Zero(), squares = Vec3::Zero();
    double times = 0;
    for (const TrialRow& row : rows) {
        along += (row.time - when) * (row.position - middle);
        times += (row.time - when) * (row.time - when);
    }
    const Vec3 drift = times > 0 ? Vec3(along / times) : Vec3::Zero().eval();
    for (const TrialRow& row : rows)
        squares += (row.position - middle - (row.time - when) * drift).cwiseAbs2();
    return std::sqrt(squares.maxCoeff() / double(rows.size()));
}

double resolutionOf(std::span<const TrialRow> rows) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (const double step = (rows[i].position - rows[i - 1].position).norm(); step > 1e-9)
            steps.push_back(step);
    if (steps.empty()) return 0;
    const auto tenth = steps.begin() + std::ptrdiff_t(steps.size() / 10);
    std::nth_element(steps.begin(), tenth, steps.end());
    return *tenth;
}

Vec3 middleOf(std::span<const TrialRow> rows) {
    Vec3 sum = Vec3::Zero();
    for (const TrialRow& row : rows)
        sum += row.position;
    return rows.empty() ? sum : Vec3(sum / double(rows.size()));
}

std::optional<AxisDynamics> dynamicsOf(std::span<const TrialRow> rows, int axis) {
    const auto count = Eigen::Index(rows.size());
    constexpr Eigen::Index kEdge = 3 * kSmooth + 35; // of the smoothing, and of the longest delay
    if (count < 4 * kEdge) return {};
    const Even even = evenly(rows, axis);
    const Series &x = even.place, &force = even.force;
    const double dt = even.dt;
    if (std::sqrt((x.array() - x.mean()).square().mean()) < kMoves) return {};

    const Series seen = smooth(x), speed = slope(seen, dt), acceleration = slope(speed, dt);
    const Series quick = slope(smooth(x, kSmoothSign), dt);
    const Series still = smooth((quick.array().abs() < kStill).cast<double>().matrix());
    std::vector<Eigen::Index> used;
    for (Eigen::Index i = kEdge; i + kEdge < count; ++i)
        if (still[i] < kMostStill) used.push_back(i);
    if (Eigen::Index(used.size()) < kEdge) return {};
    Eigen::MatrixXd sides(used.size(), 4);
    sides.col(0) = acceleration(used);
    sides.col(1) = speed(used);
    sides.col(2) = smooth((quick / kStill).cwiseMax(-1).cwiseMin(1))(used);
    sides.col(3).setOnes();

    const auto remainderAt = [&](double delay) {
        return fitAxis(sides, smooth(late(force, delay, dt))(used));
    };
    int best = 0;
    std::vector<double> remainders;
    for (int trial = 0; trial < kTrials; ++trial) {
        remainders.push_back(remainderAt(kLongest * trial / (kTrials - 1)).remainder);
        if (remainders.back() < remainders[std::size_t(best)]) best = trial;
    }
    // Squares of the remainder are a parabola about the best delay: between two trials it is nearer than to
    // either.
    const double step = kLongest / (kTrials - 1);
    double delay = step * best;
    if (best > 0 && best + 1 < kTrials) {
        const auto square = [&](int trial) { return std::pow(remainders[std::size_t(trial)], 2); };
        const double bend = square(best - 1) - 2 * square(best) + square(best + 1);
        if (bend > 0) delay += step * 0.5 * (square(best - 1) - square(best + 1)) / bend;
    }
    const Fit found = remainderAt(delay);
    const double whole = std::sqrt(smooth(force)(used).array().square().mean());
    return AxisDynamics{.mass = {found.values[0], found.errors[0]},
                        .damping = {found.values[1], found.errors[1]},
                        .friction = {found.values[2], found.errors[2]},
                        .delay = {std::max(0.0, delay - 0.5 * dt), step},
                        .unexplained = whole > 0 ? found.remainder / whole : 1};
}

} // namespace tactum
