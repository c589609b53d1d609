// SPDX-License-Identifier: MIT
#include "tests/bench/bench_work_precision.h"

#include "tests/bench/movers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>
#include <sstream>

namespace hyrax::bench {
namespace {

// Rates are whole numbers, so that a frame falls on every whole second.
constexpr int slowest_rate = 15;
constexpr int fastest_rate = 15'360;
constexpr double loosest_tolerance = 1e-4;
constexpr double tightest_tolerance = 1e-13;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Sample {
    int second = 0;
    Vec2 position;
    bool at_rest = false;
};

struct SolvedScene {
    BodyScene scene;
    std::vector<Sample> samples;
    // What is timed [s]. Explicit methods need minutes for more of the stiff one.
    int horizon() const { return scene.law.drag > 1e3 ? 1 : 5; }
};

struct Cell {
    Method method = Method::document;
    int rate = 0;            // [1/s]; 0: from sample to sample.
    double tolerance = 0.0;  // Of rk45.
    double setting() const { return method == Method::rk45 ? tolerance : rate; }
};

using Row = std::map<std::string, std::string>;

double number(const Row& row, const std::string& column) {
    return std::strtod(row.at(column).c_str(), nullptr);
}

BodyScene scene_of(const Row& row) {
    const PhysicsConstants constants{
        .gravity = number(row, "G"),
        .restitution = number(row, "beta"),
        .air_drag = number(row, "alpha"),
        .ground_friction = number(row, "mu"),
        .rest_threshold = number(row, "eps"),
    };
    const Size room{
        static_cast<int>(number(row, "right")), static_cast<int>(number(row, "bottom"))
    };
    BodyScene scene = box_scene(
        constants,
        room,
        {number(row, "x0"), number(row, "y0")},
        {number(row, "vx0"), number(row, "vy0")}
    );
    scene.name = row.at("scene");
    // Of the logarithm of a multiplier the last bit is anyone's: the references used these.
    scene.law.drag = number(row, "k");
    scene.law.ground_drag = number(row, "k") + number(row, "c");
    return scene;
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) {
        words.push_back(word);
    }
    return words;
}

std::vector<SolvedScene> read_references(const std::filesystem::path& path) {
    std::vector<SolvedScene> scenes;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> columns = split(line);
    while (std::getline(file, line)) {
        const std::vector<std::string> words = split(line);
        Row row;
        for (std::size_t i = 0; i < std::min(columns.size(), words.size()); ++i) {
            row[columns[i]] = words[i];
        }
        if (scenes.empty() || scenes.back().scene.name != row.at("scene")) {
            scenes.push_back({scene_of(row), {}});
        }
        scenes.back().samples.push_back({
            .second = static_cast<int>(number(row, "t")),
            .position = {number(row, "x"), number(row, "y")},
            .at_rest = number(row, "at_rest") == 1.0,
        });
    }
    return scenes;
}

std::vector<Cell> all_cells() {
    std::vector<Cell> cells;
    for (const auto& [method, name] : methods) {
        if (method == Method::rk45) {
            for (double t = loosest_tolerance; t > 0.5 * tightest_tolerance; t /= 10.0) {
                cells.push_back({.method = method, .tolerance = t});
            }
            continue;
        }
        if (method == Method::event_driven) {
            cells.push_back({.method = method});
        }
        for (int rate = slowest_rate; rate <= fastest_rate; rate *= 2) {
            cells.push_back({.method = method, .rate = rate});
        }
    }
    return cells;
}

// From one whole second to a later one.
template <typename Mover>
Vec2 move_on(Mover& mover, int rate, int from, int to) {
    if (rate == 0) {
        return mover.go_to(to * ticks_per_second, to - from);
    }
    Vec2 position;
    double sum = 0.0;
    const double dt = 1.0 / rate;
    for (long frame = long{from} * rate + 1; frame <= long{to} * rate; ++frame) {
        position = mover.go_to(frame * ticks_per_second / rate, dt);
        sum += position.x + position.y;
    }
    keep(sum);
    return position;
}

struct Errors {
    double after_1 = nan;
    double after_2 = nan;
    double after_5 = nan;
    double at_rest = nan;
};

Errors errors_of(const SolvedScene& solved, const Cell& cell) {
    Errors errors;
    with_mover(cell.method, solved.scene, cell.tolerance, [&](auto mover) {
        int second = 0;
        for (const Sample& sample : solved.samples) {
            const Vec2 off = move_on(mover, cell.rate, second, sample.second) - sample.position;
            second = sample.second;
            const double error = std::hypot(off.x, off.y);
            switch (second) {
                case 1:
                    errors.after_1 = error;
                    break;
                case 2:
                    errors.after_2 = error;
                    break;
                case 5:
                    errors.after_5 = error;
                    break;
                default:
                    break;
            }
            errors.at_rest = sample.at_rest ? error : nan;
        }
    });
    return errors;
}

Cost cost_of(const SolvedScene& solved, const Cell& cell, Meter& meter) {
    const int horizon = solved.horizon();
    const auto work = [&] {
        with_mover(cell.method, solved.scene, cell.tolerance, [&](auto mover) {
            keep(move_on(mover, cell.rate, 0, horizon).x);
        });
    };
    return meter.measure(work).per(horizon);
}

std::string setting_text(const Cell& cell) {
    if (cell.method == Method::rk45) {
        return fmt::format("tolerance {:.0e}", cell.tolerance);
    }
    return cell.rate == 0 ? "events only" : fmt::format("1/{} s", cell.rate);
}

bool wanted(const CellFilter& filter, const SolvedScene& solved, const Cell& cell) {
    const double off = std::fabs(filter.setting - cell.setting());
    return (filter.scene.empty() || filter.scene == solved.scene.name) &&
           (filter.method.empty() || filter.method == name_of(cell.method)) &&
           (filter.setting < 0.0 || off <= 1e-6 * cell.setting());
}

void write_title(std::ostream& table, const std::string& scene) {
    table << fmt::format(
        "\n{}: error [px] after 1, 2, 5 s and at rest; cost of a simulated second\n"
        "{:<20}{:<17}{:>10}{:>10}{:>10}{:>10}{:>10}{:>13}\n",
        scene,
        "integrator",
        "step",
        "1 s",
        "2 s",
        "5 s",
        "rest",
        "ns",
        "instructions"
    );
}

}  // namespace

bool work_precision(
    std::ostream& table,
    std::ostream& csv,
    Meter& meter,
    const std::filesystem::path& references,
    const CellFilter& filter
) {
    const std::vector<SolvedScene> scenes = read_references(references);
    if (scenes.empty()) {
        fmt::print(stderr, "work-precision: cannot read {}\n", references.string());
        return false;
    }
    const std::vector<Cell> cells = all_cells();
    Progress progress("work-precision", scenes.size() * cells.size());
    csv << "scene,method,rate,tolerance,error_1,error_2,error_5,error_rest,ns,instructions\n";
    for (const SolvedScene& solved : scenes) {
        bool titled = false;
        for (const Cell& cell : cells) {
            progress.step();
            if (!wanted(filter, solved, cell)) {
                continue;
            }
            if (!titled) {
                titled = true;
                write_title(table, solved.scene.name);
            }
            const Errors e = errors_of(solved, cell);
            const Cost cost = cost_of(solved, cell, meter);
            table << fmt::format("{:<20}{:<17}", name_of(cell.method), setting_text(cell))
                  << short_number(e.after_1) << short_number(e.after_2) << short_number(e.after_5)
                  << short_number(e.at_rest) << short_number(cost.nanoseconds) << "   "
                  << short_number(cost.instructions) << '\n';
            csv << fmt::format(
                "{},{},{},{},{:.3e},{:.3e},{:.3e},{:.3e},{:.4g},{:.6g}\n",
                solved.scene.name,
                name_of(cell.method),
                cell.rate,
                cell.tolerance,
                e.after_1,
                e.after_2,
                e.after_5,
                e.at_rest,
                cost.nanoseconds,
                cost.instructions
            );
        }
    }
    return true;
}

}  // namespace hyrax::bench
