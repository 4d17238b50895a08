// A maze whose walls are thinner than the proxy: whoever presses does not get through, only around.
#include <cstdint>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

constexpr int kCells = 7;
constexpr double kCell = 0.018, kWall = 0.0016, kHeight = 0.007; // m; the proxy is 2 mm across

/// Which walls stand. A cell has one to its west and one to its south; the last row and column close it.
class Maze {
public:
    Maze() { carve(0, 0); }

    bool wallWest(int x, int y) const { return x == 0 || x == kCells || west_[y][x]; }
    bool wallSouth(int x, int y) const { return y == 0 || y == kCells || south_[y][x]; }

    struct Cell {
        int x, y;
        bool operator==(const Cell&) const = default;
    };
    /// The only way from one cell to another.
    std::vector<Cell> way(Cell from, Cell to) const {
        std::vector<Cell> cells;
        find(from, to, {-1, -1}, cells);
        return {cells.rbegin(), cells.rend()};
    }

private:
    using Walls = std::array<std::array<bool, kCells>, kCells>;
    static constexpr Walls allOf(bool value) {
        Walls walls{};
        for (auto& row : walls)
            row.fill(value);
        return walls;
    }

    /// Goes on to a neighbour where nobody was, by chance, as long as there is one.
    void carve(int x, int y) {
        seen_[y][x] = true;
        const std::uint32_t first = next();
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t way = (first + i) % 4;
            const int to[2] = {x + (way == 0) - (way == 1), y + (way == 2) - (way == 3)};
            if (to[0] < 0 || to[1] < 0 || to[0] >= kCells || to[1] >= kCells || seen_[to[1]][to[0]]) continue;
            (way < 2 ? west_ : south_)[std::max(y, to[1])][std::max(x, to[0])] = false;
            carve(to[0], to[1]);
        }
    }
    /// Appends the cells of the way backward; nothing for a blind alley.
    bool find(Cell at, Cell to, Cell before, std::vector<Cell>& cells) const {
        bool found = at == to;
        const auto go = [&](Cell next, bool closed) {
            found = found || (!closed && !(next == before) && find(next, to, at, cells));
        };
        go({at.x + 1, at.y}, wallWest(at.x + 1, at.y));
        go({at.x - 1, at.y}, wallWest(at.x, at.y));
        go({at.x, at.y + 1}, wallSouth(at.x, at.y + 1));
        go({at.x, at.y - 1}, wallSouth(at.x, at.y));
        if (found) cells.push_back(at);
        return found;
    }
    std::uint32_t next() {
        chance_ = chance_ * 1664525U + 1013904223U;
        return chance_ >> 24;
    }

    Walls west_ = allOf(true), south_ = allOf(true), seen_ = allOf(false);
    std::uint32_t chance_ = 11;
};

/// A line of the grid, in m.
double at(int line) {
    return (line - kCells / 2.0) * kCell;
}

/// One box for each run of walls on a line. `standsAt(i)`: whether the i-th wall of the line does.
template <class StandsAt, class Add> void addRuns(const StandsAt& standsAt, const Add& add) {
    for (int i = 0; i < kCells; ++i) {
        if (!standsAt(i)) continue;
        const int begin = i;
        while (i + 1 < kCells && standsAt(i + 1))
            ++i;
        add(at(begin) - kWall / 2, at(i + 1) + kWall / 2);
    }
}

SceneObject walls() {
    const Maze maze;
    Mesh mesh;
    for (int line = 0; line <= kCells; ++line) {
        const double low = at(line) - kWall / 2, high = at(line) + kWall / 2;
        addRuns([&](int i) { return maze.wallWest(line, i); },
                [&](double from, double to) {
                    mesh.box({low, 0, from}, {high, kHeight, to});
                });
        addRuns([&](int i) { return maze.wallSouth(i, line); },
                [&](double from, double to) {
                    mesh.box({from, 0, low}, {to, kHeight, high});
                });
    }
    return object("walls", mesh, {surface("wall", {0.16f, 0.30f, 0.44f}, {.stiffness = 800})});
}

/// A place to begin or to reach, slightly raised and rough.
SceneObject mat(std::string name, int x, int y, const Eigen::Vector3f& colour) {
    constexpr double kRim = 0.004;
    Mesh mesh;
    mesh.box({at(x) + kRim, 0, at(y) + kRim}, {at(x + 1) - kRim, 0.0004, at(y + 1) - kRim});
    return object(name, mesh, {surface(name, colour, {.staticFriction = 0.9, .dynamicFriction = 0.7})});
}

/// Pushes against the outer wall, gives up, and goes on toward the goal, around the ends of the walls so
/// closely that they hold the proxy back.
std::shared_ptr<const std::vector<FingerPoint>> aroundTheWalls() {
    constexpr std::size_t kFar = 9; // cells
    constexpr double kClose = 0.97; // of the way to the wall's end, where a corner is cut
    const std::vector<Maze::Cell> way = Maze().way({0, kCells - 1}, {kCells - 1, 0});
    const auto middle = [&](std::size_t i) {
        return Vec3(at(way[i].x) + kCell / 2, kHeight / 2, at(way[i].y) + kCell / 2);
    };
    const Vec3 up(0, 0.015, 0), start = middle(0), aside = start - Vec3(kCell / 2 + 0.002, 0, 0);
    std::vector<FingerKey> keys{{0, start + up}, {0.3, start}, {0.6, aside}, {0.8, start}};
    for (std::size_t i = 1; i < kFar; ++i) {
        // At a corner the sum points to the end of the inner wall; on a straight way it is nothing.
        const Vec3 inward = middle(i - 1) + middle(i + 1) - 2 * middle(i);
        const Vec3 next = middle(i) + kClose / 2 * inward;
        keys.push_back({keys.back().t + 8 * (next - keys.back().at).norm(), next});
    }
    const FingerKey last = keys.back();
    keys.push_back({last.t + 0.2, last.at + up});
    return fingerPath(keys, [](const Vec3& p) { return p; });
}

} // namespace

Scene thinWallMaze() {
    const double side = at(kCells) + 0.004;
    Mesh floor;
    floor.box({-side, -0.006, -side}, {side, 0, side});
    Scene scene;
    scene.add(walls());
    scene.add(object("floor", floor, {surface("floor", {0.62f, 0.60f, 0.54f}, {.stiffness = 800})}));
    scene.add(mat("start", 0, kCells - 1, {0.15f, 0.50f, 0.18f}));
    scene.add(mat("goal", kCells - 1, 0, {0.65f, 0.12f, 0.08f}));
    scene.finger = aroundTheWalls();
    return scene;
}

} // namespace tactum::samples
