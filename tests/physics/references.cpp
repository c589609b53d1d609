// SPDX-License-Identifier: MIT
#include "tests/physics/references.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hyrax::test {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

double number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') {
        throw std::runtime_error("not a number: \"" + text + "\"");
    }
    return value;
}

Mode mode_named(const std::string& name) {
    if (name == "AIR") {
        return Mode::air;
    }
    if (name == "GROUND") {
        return Mode::ground;
    }
    if (name == "REST") {
        return Mode::rest;
    }
    throw std::runtime_error("not a mode: " + name);
}

FreeSpace space_of(const std::string& text) {
    std::vector<Obstacle> obstacles;
    std::vector<Ledge> ledges;
    for (const std::string& item : split(text, ';')) {
        const std::vector<std::string> sides = split(item, ':');
        if (sides.size() == 3) {
            ledges.push_back(
                {.left = std::stoi(sides[1]), .right = std::stoi(sides[2]), .y = std::stoi(sides[0])
                }
            );
            continue;
        }
        obstacles.push_back(
            {number(sides.at(0)), number(sides.at(1)), number(sides.at(2)), number(sides.at(3))}
        );
    }
    const FreeSpace space(std::move(obstacles));
    // They are those of the body's corner already.
    return ledges.empty() ? space : space.with_ledges(ledges, {});
}

ReferenceScene scene_of(const std::vector<std::string>& row) {
    const double drag = number(row[2]);
    const double gravity = number(row[4]);
    return {
        .name = row[0],
        .family = row[1],
        .law =
            {.gravity = gravity,
             .drag = drag,
             .ground_drag = drag + number(row[3]),
             .restitution = number(row[5]),
             .impact_friction = number(row[6]),
             .rest_speed = std::max(number(row[7]), std::sqrt(2.0 * gravity * visible_hop)),
             .stop_speed = number(row[8])},
        .position = {number(row[9]), number(row[10])},
        .velocity = {number(row[11]), number(row[12])},
        .space = space_of(row[13]),
        .samples = {},
    };
}

}  // namespace

std::vector<ReferenceScene> read_references(const std::string& file) {
    constexpr std::size_t columns = 21;
    std::ifstream stream(file);
    if (!stream) {
        throw std::runtime_error("cannot read " + file);
    }
    std::vector<ReferenceScene> scenes;
    bool in_head = true;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#')) {
            continue;
        }
        if (std::exchange(in_head, false)) {
            continue;
        }
        const std::vector<std::string> row = split(line, ',');
        if (row.size() != columns) {
            throw std::runtime_error(file + ": not a row of the table: " + line);
        }
        if (scenes.empty() || scenes.back().name != row[0]) {
            scenes.push_back(scene_of(row));
        }
        scenes.back().samples.push_back(
            {.time = std::stoll(row[14]),
             .position = {number(row[15]), number(row[16])},
             .velocity = {number(row[17]), number(row[18])},
             .mode = mode_named(row[19]),
             .events = std::stoi(row[20])}
        );
    }
    return scenes;
}

}  // namespace hyrax::test
