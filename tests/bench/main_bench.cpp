// SPDX-License-Identifier: MIT
// hyrax-bench: the figures behind docs/numerics.md.
#include "tests/bench/bench_compose.h"
#include "tests/bench/bench_energy.h"
#include "tests/bench/bench_frame_rate.h"
#include "tests/bench/bench_identity.h"
#include "tests/bench/bench_peers.h"
#include "tests/bench/bench_scene_cost.h"
#include "tests/bench/bench_springs.h"
#include "tests/bench/bench_stability.h"
#include "tests/bench/bench_throughput.h"
#include "tests/bench/bench_trajectory.h"
#include "tests/bench/bench_work_precision.h"
#include "tests/bench/movers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace hyrax::bench {
namespace {

struct Options {
    std::string csv;
    double seconds_per_cell = 0.01;
    bool count_instructions = false;
    bool inside_valgrind = false;
    long frames = 1'000'000;
    std::uint64_t steps = 100'000'000;
    std::string references = HYRAX_SOURCE_DIR "/tests/golden/work_precision.csv";
    std::vector<std::string> cell;
    std::string scene_file;
    TrajectoryOptions trajectory;
};

// The file that --csv names, or nothing.
class CsvFile {
public:
    explicit CsvFile(const std::string& path) {
        if (!path.empty()) {
            file_.open(path);
            if (!file_) {
                throw std::runtime_error(fmt::format("cannot write {}", path));
            }
        }
    }
    std::ostream& stream() { return file_.is_open() ? file_ : nowhere_; }

private:
    std::ofstream file_;
    std::ostream nowhere_{nullptr};
};

Meter make_meter(const Options& options, int argc, const char* const* argv) {
    if (options.inside_valgrind) {
        return Meter(0.0, counted_by_valgrind(), false);
    }
    InstructionCounter counter;
    if (options.count_instructions) {
        counter = hardware_counter();
        if (!counter) {
            fmt::print(stderr, "no hardware counters here: counting in a run inside valgrind\n");
            counter = valgrind_counter(argc, argv);
        }
        if (!counter) {
            fmt::print(stderr, "no valgrind either: instructions are not counted\n");
        }
    }
    return Meter(options.seconds_per_cell, std::move(counter));
}

CellFilter filter_of(const std::vector<std::string>& cell) {
    CellFilter filter;
    if (cell.size() == 3) {
        filter = {cell[0], cell[1], std::strtod(cell[2].c_str(), nullptr)};
        if (!method_named(filter.method)) {
            throw std::runtime_error(fmt::format("there is no integrator \"{}\"", filter.method));
        }
    }
    return filter;
}

void add_trajectory(CLI::App& app, Options& options) {
    TrajectoryOptions& t = options.trajectory;
    CLI::App& sub =
        *app.add_subcommand("trajectory", "One motion as CSV on stdout, with 17 digits");
    sub.add_option("scene", options.scene_file, "JSON file with the names of the options below")
        ->check(CLI::ExistingFile);
    sub.add_option("--at", t.at, "x,y of the top-left corner [px]")->delimiter(',')->expected(2);
    sub.add_option("--velocity", t.velocity, "vx,vy [px/s]")->delimiter(',')->expected(2);
    sub.add_option("--box", t.box, "left,top,right,bottom for the top-left corner [px]")
        ->delimiter(',')
        ->expected(4);
    sub.add_option("--monitors", t.monitors, "Instead of a box: 1920x1080+0+0,1600x900+1920+0");
    sub.add_option("--size", t.size, "width,height of the body among monitors [px]")
        ->delimiter(',')
        ->expected(2);
    sub.add_option("--gravity", t.constants.gravity, "[px/s^2]");
    sub.add_option("--restitution", t.constants.restitution, "Speed kept by an impact");
    sub.add_option("--air-drag", t.constants.air_drag, "Velocity kept by a frame at 60 Hz");
    sub.add_option("--ground-friction", t.constants.ground_friction, "The same on the ground");
    sub.add_option("--rest-threshold", t.constants.rest_threshold, "Slowest rebound [px/s]");
    sub.add_option("--reference-rate", t.reference_rate, "Frames a second of these multipliers");
    sub.add_option("--integrator", t.integrator, "As in config.json");
    sub.add_option("--frame", t.frame, "Length of a frame, for all but event_driven [s]");
    sub.add_option("--times", t.times, "Moments to print [s]")->delimiter(',');
    sub.add_option("--every", t.every, "Without --times: how far apart [s]");
    sub.add_option("--until", t.until, "Without --times: the last moment [s]");
}

void add_all(CLI::App& app, Options& options) {
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--csv", options.csv, "Write the figures to this file as well");
    app.add_option("--seconds-per-cell", options.seconds_per_cell, "Time for each figure [s]")
        ->check(CLI::Range(0.0, 60.0));
    app.add_flag(
        "--count-instructions",
        options.count_instructions,
        "With the processor's counters, or else inside valgrind"
    );
    app.add_flag(inside_valgrind_flag, options.inside_valgrind)->group("");

    CLI::App& precision = *app.add_subcommand("work-precision", "Error against cost");
    precision.add_option("--references", options.references, "tests/golden/work_precision.csv");
    precision
        .add_option(
            "--cell",
            options.cell,
            "Only: scene, integrator, frames a second (rk45: its tolerance; 0: events only)"
        )
        ->expected(3);
    app.add_subcommand("stability", "The catalogue of cases an integrator must withstand");
    app.add_subcommand("energy", "Energy of an elastic body")
        ->add_option("--frames", options.frames, "How many")
        ->check(CLI::Range(1L, 1'000'000'000L));
    app.add_subcommand("frame-rate", "The same throw at different frame rates");
    app.add_subcommand("compose", "Drawing a hundred sprites into a pane");
    app.add_subcommand("springs", "How time steppers follow a cursor on a spring");
    app.add_subcommand("throughput", "The document's step for many bodies");
    app.add_subcommand("identity", "Whether the kernels give the bits of the document's class")
        ->add_option("--steps", options.steps, "Random steps of one body for each kernel");
    app.add_subcommand("scene-cost", "What each feature of a scene costs");
    app.add_subcommand("peers", "General physics engines, as far as built in");
    add_trajectory(app, options);
}

// The file comes first, so that the command line can change what it says.
void parse(CLI::App& app, Options& options, int argc, const char* const* argv) {
    app.parse(argc, argv);
    if (!options.scene_file.empty()) {
        const std::string file = options.scene_file;
        options.trajectory = {};
        read_scene(file, options.trajectory);
        app.parse(argc, argv);
    }
}

bool run(const std::string& bench, const Options& options, int argc, const char* const* argv) {
    CsvFile file(options.csv);
    std::ostream& csv = file.stream();
    std::ostream& table = std::cout;
    if (bench == "work-precision") {
        const CellFilter filter = filter_of(options.cell);
        Meter meter = make_meter(options, argc, argv);
        return work_precision(table, csv, meter, options.references, filter);
    }
    if (bench == "identity") {
        return identity(table, csv, options.steps);
    }
    if (bench == "scene-cost") {
        Meter meter = make_meter(options, argc, argv);
        scene_cost(table, csv, meter);
    } else if (bench == "compose") {
        Meter meter = make_meter(options, argc, argv);
        compose_crowd(table, csv, meter);
    } else if (bench == "stability") {
        stability(table, csv);
    } else if (bench == "energy") {
        energy(table, csv, options.frames);
    } else if (bench == "frame-rate") {
        frame_rate(table, csv);
    } else if (bench == "springs") {
        springs(table, csv);
    } else if (bench == "throughput") {
        throughput(table, csv, options.seconds_per_cell);
    } else if (bench == "peers") {
        peers(table, csv, options.seconds_per_cell);
    } else {
        trajectory(options.csv.empty() ? table : csv, options.trajectory);
    }
    return true;
}

}  // namespace
}  // namespace hyrax::bench

int main(int argc, char** argv) {
    using namespace hyrax::bench;
    CLI::App app("Figures on hyrax's integrators", "hyrax-bench");
    Options options;
    add_all(app, options);
    try {
        parse(app, options, argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "hyrax-bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
    try {
        const std::string bench = app.get_subcommands().front()->get_name();
        return run(bench, options, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "hyrax-bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
