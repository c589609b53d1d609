// SPDX-License-Identifier: MIT
#include "tests/bench/bench_compose.h"

#include "daemon/core/atlas.h"
#include "daemon/core/dirty.h"
#include "daemon/core/sprite_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace hyrax::bench {
namespace {

constexpr Size pane{1920, 1080};
constexpr Size sprite_size{128, 128};
constexpr int sprites = 100;

Frame crowd(const CellPicture& picture, std::uint8_t opacity) {
    std::minstd_rand random(1);
    const auto up_to = [&random](int most) {
        return static_cast<int>(random() % (static_cast<unsigned>(most) + 1));
    };
    Frame frame;
    for (int i = 0; i < sprites; ++i) {
        const Point at{
            up_to(pane.width - sprite_size.width), up_to(pane.height - sprite_size.height)
        };
        frame.sprites.emplace_back(*picture.image, at, PetId{}, opacity);
    }
    return frame;
}

// Over whatever is there: what a kernel alone takes.
Work stamping(const PixelView& target, const Frame& frame, Kernel kernel) {
    return [&target, &frame, kernel] {
        for (const Sprite& sprite : frame.sprites) {
            const Stamp stamp{*sprite.image, sprite.at, sprite.opacity};
            blit(target, {0, 0, pane.width, pane.height}, stamp, kernel);
        }
    };
}

Work composing(const PixelView& target, const Frame& frame, Kernel kernel) {
    return [&target, &frame, kernel] {
        compose(target, {}, {0, 0, pane.width, pane.height}, frame, kernel);
    };
}

// As one frame follows another.
Work recomposing(
    const PixelView& target, std::span<const Rect> before, const Frame& frame, Kernel kernel
) {
    return [&target, before, &frame, kernel] {
        constexpr Rect whole{0, 0, pane.width, pane.height};
        recompose(target, {}, std::span(&whole, 1), before, frame, kernel);
    };
}

std::string milliseconds(double nanoseconds) {
    return fmt::format("{:.3f}", nanoseconds / 1e6);
}

}  // namespace

void compose_crowd(std::ostream& table, std::ostream& csv, Meter& meter) {
    const SpriteSet set = placeholder_sprite_set("hyrax");
    Atlas atlas;
    const CellPicture picture = atlas.cell(set, 0, 0, false, sprite_size);
    const Frame drawn = crowd(picture, 255);
    const Frame faded = crowd(picture, 200);
    Image canvas(pane);
    const PixelView target(canvas);

    table << fmt::format(
        "ms for {} sprites of {}x{} in {}x{}\n{:<10}{:>10}{:>10}{:>16}{:>16}{:>12}{:>10}{:>14}\n",
        sprites,
        sprite_size.width,
        sprite_size.height,
        pane.width,
        pane.height,
        "renderer",
        "drawn",
        "faded",
        "erased, drawn",
        "erased, faded",
        "next frame",
        "cold",
        "erased, cold"
    );
    csv << "renderer,drawn_ms,faded_ms,erased_drawn_ms,erased_faded_ms,next_frame_ms,cold_ms,"
           "only_erased_cold_ms\n";
    const auto report = [&](std::string_view title, const std::vector<std::string>& cells) {
        table << fmt::format(
                     "{:<10}{:>10}{:>10}{:>16}{:>16}", title, cells[0], cells[1], cells[2], cells[3]
                 )
              << fmt::format("{:>12}{:>10}{:>14}\n", cells[4], cells[5], cells[6]) << std::flush;
        csv << fmt::format("{},{}\n", title, fmt::join(cells, ","));
    };
    const auto measured = [&meter](const Work& work) {
        return milliseconds(meter.measure(work).nanoseconds);
    };
    const std::vector<Rect> before = places_of(drawn);
    const std::string only_erased = milliseconds(cold_nanoseconds([&] {
        for (const Rect& place : before) {
            erase(target, place);
        }
    }));
    for (const Kernel kernel : available_blit_kernels()) {
        const Work next = recomposing(target, before, drawn, kernel);
        report(
            name(kernel),
            {measured(stamping(target, drawn, kernel)),
             measured(stamping(target, faded, kernel)),
             measured(composing(target, drawn, kernel)),
             measured(composing(target, faded, kernel)),
             measured(next),
             milliseconds(cold_nanoseconds(next)),
             only_erased}
        );
    }
    if (const Composer composer = gdiplus_composer()) {
        report(
            "gdiplus",
            {"",
             "",
             measured([&] { composer(target, drawn); }),
             measured([&] { composer(target, faded); }),
             "",
             "",
             ""}
        );
    }
}

}  // namespace hyrax::bench
