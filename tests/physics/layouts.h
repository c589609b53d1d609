// SPDX-License-Identifier: MIT
// Desktops of several monitors, and by brute force where a box may be on them.
#pragma once

#include "physics/geometry.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace hyrax::test {

struct Layout {
    std::string name;
    std::vector<Rect> rooms;
    Size box;
    /// Slits below 2 px between rooms, which count as room.
    std::vector<Rect> slits = {};
};

inline std::vector<Rect> wall_of_monitors(int columns, int rows) {
    std::vector<Rect> rooms;
    for (int i = 0; i < columns * rows; ++i) {
        rooms.push_back({(i % columns) * 1280 - 4000, (i / columns) * 1024 - 1500, 1280, 1024});
    }
    return rooms;
}

inline std::vector<Layout> layouts() {
    const Size pet{128, 96};
    const Rect main{0, 0, 1920, 1040};
    const Rect beside{1920, 0, 1920, 1040};
    return {
        {"one", {main}, pet},
        {"side by side", {main, beside}, pet},
        {"work areas of two heights", {main, {1920, 0, 1920, 1080}}, pet},
        {"l", {main, {0, 1040, 1080, 1920}}, pet},
        {"t", {main, {1920, -400, 1080, 1920}, {3000, 0, 1920, 1040}}, pet},
        {"t upside down", {{0, 0, 5760, 1080}, {1920, 1080, 1920, 1080}}, pet},
        {"gap of 40", {main, {1960, 0, 1920, 1040}}, pet},
        {"gap of 1", {main, {1921, 0, 1920, 1040}}, pet, {{1920, 0, 1, 1040}}},
        {"gap of 1 below", {main, {0, 1041, 1920, 800}}, pet, {{0, 1040, 1920, 1}}},
        {"gap of 2", {main, {1922, 0, 1920, 1040}}, pet},
        {"stairs", {main, {1920, 300, 1280, 1024}, {3200, 700, 1024, 768}}, pet},
        {"left and above", {main, {-1440, -900, 1440, 900}, {-1440, 0, 1440, 900}}, pet},
        {"all negative", {{-5000, -3000, 1600, 900}, {-3400, -2800, 1920, 1080}}, pet},
        {"one inside the other", {main, {500, 300, 640, 480}}, pet},
        {"overlapping", {main, {1500, 600, 1920, 1080}}, pet},
        {"nothing but a corner", {main, {1920, 1040, 1920, 1040}}, pet},
        {"narrow slot", {main, {800, 1040, 140, 900}, {0, 1940, 1920, 700}}, pet},
        {"slot as wide as the pet", {main, {800, 1040, 128, 900}, {0, 1940, 1920, 700}}, pet},
        {"slot of one pixel less", {main, {800, 1040, 127, 900}, {0, 1940, 1920, 700}}, pet},
        {"thirty-two", wall_of_monitors(8, 4), {64, 64}},
        {"thirty-two with holes",
         [] {
             std::vector<Rect> rooms = wall_of_monitors(8, 5);
             for (const std::ptrdiff_t hole : {35, 30, 27, 21, 18, 12, 9, 0}) {
                 rooms.erase(rooms.begin() + hole);
             }
             return rooms;
         }(),
         {200, 150}},
        {"pet wider than a monitor", {{0, 0, 200, 900}, {200, 0, 900, 700}}, {300, 200}},
        {"pet as high as the monitor", {main, {1920, 0, 1280, 800}}, {128, 1040}},
    };
}

/// True if the rooms cover the whole box, up to `tolerance` [px] on each of its sides.
inline bool covered(
    const std::vector<Rect>& rooms, Vec2 corner, Vec2 size, double tolerance = 1e-9
) {
    const Vec2 low = corner + Vec2{tolerance, tolerance};
    const Vec2 high = corner + size - Vec2{tolerance, tolerance};
    std::vector<double> xs{low.x, high.x};
    std::vector<double> ys{low.y, high.y};
    for (const Rect& room : rooms) {
        for (const int x : {room.x, room.right()}) {
            if (x > low.x && x < high.x) {
                xs.push_back(x);
            }
        }
        for (const int y : {room.y, room.bottom()}) {
            if (y > low.y && y < high.y) {
                ys.push_back(y);
            }
        }
    }
    std::ranges::sort(xs);
    std::ranges::sort(ys);
    // No side of a room runs through a cell: its middle speaks for it.
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
            const Vec2 middle{(xs[i] + xs[i + 1]) / 2.0, (ys[j] + ys[j + 1]) / 2.0};
            if (!std::ranges::any_of(rooms, [&](const Rect& room) {
                    return middle.x >= room.x && middle.x <= room.right() && middle.y >= room.y &&
                           middle.y <= room.bottom();
                })) {
                return false;
            }
        }
    }
    return true;
}

/// The rooms with the slits between them.
inline std::vector<Rect> all_rooms(const Layout& layout) {
    std::vector<Rect> rooms = layout.rooms;
    rooms.insert(rooms.end(), layout.slits.begin(), layout.slits.end());
    return rooms;
}

}  // namespace hyrax::test
