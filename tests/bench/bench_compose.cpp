// SPDX-License-Identifier: MIT
#include "tests/bench/bench_compose.h"

#include "daemon/core/atlas.h"
#include "daemon/core/sprite_set.h"

#include <fmt/format.h>

#include <ostream>
#include <random>
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
        frame.sprites.push_back({
            .image = picture.image,
            .source = picture.source,
            .at = {up_to(pane.width - sprite_size.width), up_to(pane.height - sprite_size.height)},
            .pet = {},
            .opacity = opacity,
        });
    }
    return frame;
}

// Over whatever is there: what a kernel alone takes.
Work stamping(const PixelView& target, const Frame& frame, Kernel kernel) {
    return [&target, &frame, kernel] {
        for (const Sprite& sprite : frame.sprites) {
            const Stamp stamp{*sprite.image, sprite.source, sprite.at, sprite.opacity};
            blit(target, {0, 0, pane.width, pane.height}, stamp, kernel);
        }
    };
}

Work composing(const PixelView& target, const Frame& frame, Kernel kernel) {
    return [&target, &frame, kernel] {
        compose(target, {}, {0, 0, pane.width, pane.height}, frame, kernel);
    };
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
        "ms for {} sprites of {}x{} in {}x{}\n{:<10}{:>10}{:>10}{:>16}{:>16}\n",
        sprites,
        sprite_size.width,
        sprite_size.height,
        pane.width,
        pane.height,
        "renderer",
        "drawn",
        "faded",
        "erased, drawn",
        "erased, faded"
    );
    csv << "renderer,drawn_ms,faded_ms,erased_drawn_ms,erased_faded_ms\n";
    const auto report = [&](std::string_view title, const std::vector<Work>& works) {
        std::vector<std::string> cells;
        for (const Work& work : works) {
            cells.push_back(
                work ? fmt::format("{:.3f}", meter.measure(work).nanoseconds / 1e6) : ""
            );
        }
        table
            << fmt::format(
                   "{:<10}{:>10}{:>10}{:>16}{:>16}\n", title, cells[0], cells[1], cells[2], cells[3]
               )
            << std::flush;
        csv << fmt::format("{},{},{},{},{}\n", title, cells[0], cells[1], cells[2], cells[3]);
    };
    for (const Kernel kernel : available_blit_kernels()) {
        report(
            name(kernel),
            {stamping(target, drawn, kernel),
             stamping(target, faded, kernel),
             composing(target, drawn, kernel),
             composing(target, faded, kernel)}
        );
    }
    if (const Composer composer = gdiplus_composer()) {
        report(
            "gdiplus", {{}, {}, [&] { composer(target, drawn); }, [&] { composer(target, faded); }}
        );
    }
}

}  // namespace hyrax::bench
