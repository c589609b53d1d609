// SPDX-License-Identifier: MIT
#include "daemon/core/speech.h"

#include "daemon/core/blit.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hyrax {
namespace {

constexpr int padding_x = 10;
constexpr int padding_y = 6;
constexpr int gap = 2;  // Between a pet and its bubble [px].
constexpr double corner = 9.0;
constexpr double border = 1.5;
constexpr Size tail_size{16, 10};
constexpr int tail_overlap = 2;  // How far the tail covers the bubble's border [px].

struct Grey {
    double value = 0.0;    // 0 black to 1 white.
    double opacity = 0.0;  // 0 to 1.
};

Pixel premultiplied(Grey grey) {
    const auto alpha = static_cast<Pixel>(std::lround(grey.opacity * 255.0));
    const auto level = static_cast<Pixel>(std::lround(grey.value * grey.opacity * 255.0));
    return alpha << 24U | level << 16U | level << 8U | level;
}

// A pixel at this signed distance from an outline, negative inside: paper with a border.
Pixel paper(double distance) {
    constexpr double paper_grey = 1.0;
    constexpr double border_grey = 0.25;
    const double cover = std::clamp(0.5 - distance, 0.0, 1.0);
    const double inner = std::clamp(0.5 - (distance + border), 0.0, 1.0);
    return premultiplied({border_grey + (paper_grey - border_grey) * inner, cover});
}

// Distance to a rounded rectangle around the origin.
double rounded_box(Vec2 p, Vec2 half, double radius) {
    const Vec2 q{std::fabs(p.x) - half.x + radius, std::fabs(p.y) - half.y + radius};
    const double outside = std::hypot(std::max(q.x, 0.0), std::max(q.y, 0.0));
    return outside + std::min(std::max(q.x, q.y), 0.0) - radius;
}

// A tail that points down. Its upper edge is open: it covers the border of the bubble.
Image tail_image() {
    Image image(tail_size);
    const double middle = tail_size.width / 2.0;
    const double tip = tail_size.height - 0.5;
    const double slope = (middle - 1.0) / tip;
    const double steepness = std::hypot(1.0, slope);
    for (int y = 0; y < tail_size.height; ++y) {
        for (int x = 0; x < tail_size.width; ++x) {
            const double half = (tip - (y + 0.5)) * slope;
            image.at(x, y) = paper((std::fabs(x + 0.5 - middle) - half) / steepness);
        }
    }
    return image;
}

Image upside_down(const Image& image) {
    Image turned(image.size);
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            turned.at(x, image.size.height - 1 - y) = image.at(x, y);
        }
    }
    return turned;
}

// The next character's end, so that nothing cuts UTF-8 apart.
std::size_t next_character(std::string_view text, std::size_t from) {
    std::size_t end = from + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
        ++end;
    }
    return end;
}

// The longest beginning that fits: up to a blank if there is one, else within the word. To measure
// is to draw, so few beginnings are.
std::size_t fitting(
    std::string_view text, const std::function<int(std::string_view)>& width, int most
) {
    std::vector<std::size_t> ends;
    for (std::size_t end = 0; end < text.size();) {
        end = next_character(text, end);
        ends.push_back(end);
    }
    const auto beyond = std::ranges::partition_point(ends, [&](std::size_t end) {
        return width(text.substr(0, end)) <= most;
    });
    if (beyond == ends.end()) {
        return text.size();
    }
    const std::size_t fits = beyond == ends.begin() ? 0 : *std::prev(beyond);
    const std::size_t blank = text.substr(0, fits + 1).rfind(' ');
    return blank != std::string_view::npos && blank > 0 ? blank : std::max(fits, ends.front());
}

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

std::vector<std::string> wrapped(
    std::string_view text,
    const std::function<int(std::string_view)>& width,
    int most,
    std::size_t lines
) {
    std::vector<std::string> result;
    text = without_blanks(text);
    while (!text.empty() && result.size() < lines) {
        const std::size_t length = fitting(text, width, most);
        result.emplace_back(text.substr(0, length));
        text = without_blanks(text.substr(length));
    }
    if (!text.empty() && !result.empty()) {
        std::string& last = result.back();
        while (!last.empty() && width(last + "...") > most) {
            do {
                last.pop_back();
            } while (!last.empty() && (static_cast<unsigned char>(last.back()) & 0xC0U) == 0x80U);
        }
        last += "...";
    }
    return result;
}

Image bubble_image(std::span<const Image> lines) {
    Size text{0, 0};
    for (const Image& line : lines) {
        text.width = std::max(text.width, line.size.width);
        text.height += line.size.height;
    }
    Image image(Size{
        std::max(text.width + 2 * padding_x, tail_size.width + 2 * static_cast<int>(corner)),
        text.height + 2 * padding_y
    });
    const Vec2 half{image.size.width / 2.0, image.size.height / 2.0};
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            image.at(x, y) = paper(rounded_box({x + 0.5 - half.x, y + 0.5 - half.y}, half, corner));
        }
    }
    const Rect all{0, 0, image.size.width, image.size.height};
    int top = padding_y;
    for (const Image& line : lines) {
        const Point at{(image.size.width - line.size.width) / 2, top};
        blit(PixelView(image), all, {.image = line, .at = at});
        top += line.size.height;
    }
    return image;
}

BubblePlace place_bubble(const Rect& box, Size bubble, Size tail, const Rect& screen) {
    const int reach = bubble.height + tail.height - tail_overlap + gap;
    const int middle = box.x + box.width / 2;
    const auto within = [](int wanted, int low, int high) {
        return std::max(low, std::min(wanted, high));
    };
    BubblePlace place;
    place.below = box.y - reach < screen.y;
    place.body.x = within(middle - bubble.width / 2, screen.x, screen.right() - bubble.width);
    place.tail.x = within(
        middle - tail.width / 2,
        place.body.x + static_cast<int>(corner),
        place.body.x + bubble.width - static_cast<int>(corner) - tail.width
    );
    if (place.below) {
        place.tail.y = box.bottom() + gap;
        place.body.y = place.tail.y + tail.height - tail_overlap;
    } else {
        place.body.y = box.y - reach;
        place.tail.y = place.body.y + bubble.height - tail_overlap;
    }
    return place;
}

Speeches::Speeches(TextPainter paint)
    : paint_(std::move(paint)), tail_down_(tail_image()), tail_up_(upside_down(tail_down_)) {}

void Speeches::show(Frame& frame, const Engine& engine, std::span<const PetId> speakers) {
    std::erase_if(bubbles_, [](const Bubble& bubble) { return bubble.retired; });
    for (Bubble& bubble : bubbles_) {
        bubble.retired = true;
    }
    if (!paint_) {
        return;
    }
    for (const PetId id : speakers) {
        const Pet& pet = *engine.find(id);
        const Bubble* const bubble = bubble_of(id, pet.speech->text);
        if (bubble == nullptr) {
            continue;
        }
        const Size size = engine.box_of(pet);
        const Rect box{
            static_cast<int>(std::lround(pet.position().x)),
            static_cast<int>(std::lround(pet.position().y)),
            size.width,
            size.height
        };
        const Rect& screen =
            engine.arena().box_near({box.x + size.width / 2.0, box.y + size.height / 2.0});
        const Size body = bubble->image.size;
        const BubblePlace place = place_bubble(box, body, tail_size, screen);
        frame.bubbles.push_back({bubble->image, place.body, id});
        frame.bubbles.push_back({place.below ? tail_up_ : tail_down_, place.tail, id});
    }
}

// Null where the text cannot be drawn.
const Speeches::Bubble* Speeches::bubble_of(PetId pet, const std::string& text) {
    for (Bubble& bubble : bubbles_) {
        if (bubble.pet == pet && bubble.text == text) {
            bubble.retired = false;
            return &bubble;
        }
    }
    const auto painted = [this](std::string_view line) {
        Result<Image> image = paint_(line);
        if (!image && !std::exchange(told_, true)) {
            spdlog::warn("speech bubbles: {}", image.error().message);
        }
        return image;
    };
    const auto width = [&painted](std::string_view line) {
        const Result<Image> image = painted(line);
        return image ? image->size.width : bubble_text_width + 1;
    };
    std::vector<Image> lines;
    for (const std::string& line : wrapped(text, width, bubble_text_width, bubble_lines)) {
        if (Result<Image> image = painted(line)) {
            lines.push_back(*std::move(image));
        }
    }
    if (lines.empty()) {
        return nullptr;
    }
    bubbles_.push_back({pet, text, bubble_image(lines), false});
    return &bubbles_.back();
}

}  // namespace hyrax
