// SPDX-License-Identifier: MIT
#include "daemon/core/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hyrax {
namespace {

// How the pixels of one axis come out of the pixels of the source.
struct Axis {
    struct Reach {
        int first;             // In the source.
        std::size_t weights;   // Begin of its weights,
        std::size_t how_many;  // one for each source pixel from `first` on; their sum is 1.
    };
    std::vector<Reach> pixels;
    std::vector<float> weights;
};

// Keys 1981, a = -1/2: goes through the samples, so that scales near 1 blur nothing.
double catmull_rom(double x) {
    x = std::fabs(x);
    if (x < 1.0) {
        return (1.5 * x - 2.5) * x * x + 1.0;
    }
    return x < 2.0 ? ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0 : 0.0;
}

Axis nearest_axis(int source, int target) {
    Axis axis;
    axis.weights.push_back(1.0F);
    for (int i = 0; i < target; ++i) {
        const auto at = static_cast<int>((2LL * i + 1) * source / (2LL * target));
        axis.pixels.push_back({at, 0, 1});
    }
    return axis;
}

// Each pixel is the mean of what it covers.
Axis smaller_axis(int source, int target) {
    Axis axis;
    const double step = static_cast<double>(source) / target;
    for (int i = 0; i < target; ++i) {
        const double begin = i * step;
        const double end = std::min<double>(source, (i + 1) * step);
        const auto first = static_cast<int>(begin);
        const auto last = std::max(first + 1, static_cast<int>(std::ceil(end)));
        axis.pixels.push_back({first, axis.weights.size(), static_cast<std::size_t>(last - first)});
        for (int at = first; at < last; ++at) {
            const double covered = std::min<double>(end, at + 1) - std::max<double>(begin, at);
            axis.weights.push_back(static_cast<float>(covered / (end - begin)));
        }
    }
    return axis;
}

// Beyond its edges the source goes on as its last pixel: an opaque picture stays opaque.
Axis larger_axis(int source, int target) {
    Axis axis;
    const double step = static_cast<double>(source) / target;
    for (int i = 0; i < target; ++i) {
        const double centre = (i + 0.5) * step - 0.5;
        const auto middle = static_cast<int>(std::floor(centre));
        const int first = std::max(0, middle - 1);
        const int last = std::min(source - 1, middle + 2);
        std::array<float, 4> weights{};
        for (int at = middle - 1; at <= middle + 2; ++at) {
            const int held = std::clamp(at, first, last) - first;
            weights[static_cast<std::size_t>(held)] += static_cast<float>(catmull_rom(centre - at));
        }
        const auto how_many = static_cast<std::size_t>(last - first + 1);
        axis.pixels.push_back({first, axis.weights.size(), how_many});
        axis.weights.insert(
            axis.weights.end(),
            weights.begin(),
            weights.begin() + static_cast<std::ptrdiff_t>(how_many)
        );
    }
    return axis;
}

Axis axis_for(int source, int target, Filter filter) {
    if (filter == Filter::nearest || source == target) {
        return nearest_axis(source, target);
    }
    return target < source ? smaller_axis(source, target) : larger_axis(source, target);
}

using Channels = std::array<float, 4>;  // Blue, green, red, alpha.

Channels channels_of(Pixel pixel) {
    Channels channels;
    for (unsigned i = 0; i < 4; ++i) {
        channels[i] = static_cast<float>((pixel >> (8 * i)) & 0xFFU);
    }
    return channels;
}

void add(Channels& sum, const Channels& one, float weight) {
    for (std::size_t i = 0; i < 4; ++i) {
        sum[i] += one[i] * weight;
    }
}

// A filter that rings leaves the range of numbers, and colours above their alpha.
Pixel pixel_of(const Channels& channels) {
    const auto whole = [](float value, float most) {
        return static_cast<Pixel>(std::clamp(value, 0.0F, most) + 0.5F);
    };
    const Pixel alpha = whole(channels[3], 255.0F);
    if (alpha < least_alpha) {
        return 0;
    }
    const auto most = static_cast<float>(alpha);
    return alpha << 24U | whole(channels[2], most) << 16U | whole(channels[1], most) << 8U |
           whole(channels[0], most);
}

}  // namespace

Image resampled(const Image& image, const Rect& part, Size size, Filter filter) {
    const Axis across = axis_for(part.width, size.width, filter);
    const Axis down = axis_for(part.height, size.height, filter);
    const auto width = static_cast<std::size_t>(size.width);

    // First all source rows in their new width, then columns.
    std::vector<Channels> wide(width * static_cast<std::size_t>(part.height));
    auto out = wide.begin();
    for (int y = 0; y < part.height; ++y) {
        for (const Axis::Reach& reach : across.pixels) {
            for (std::size_t i = 0; i < reach.how_many; ++i) {
                const int x = part.x + reach.first + static_cast<int>(i);
                add(*out, channels_of(image.at(x, part.y + y)), across.weights[reach.weights + i]);
            }
            ++out;
        }
    }

    Image result(size);
    auto pixel = result.pixels.begin();
    std::vector<Channels> row(width);
    for (const Axis::Reach& reach : down.pixels) {
        std::ranges::fill(row, Channels{});
        for (std::size_t i = 0; i < reach.how_many; ++i) {
            const float weight = down.weights[reach.weights + i];
            const std::size_t from = (static_cast<std::size_t>(reach.first) + i) * width;
            for (std::size_t x = 0; x < width; ++x) {
                add(row[x], wide[from + x], weight);
            }
        }
        pixel = std::ranges::transform(row, pixel, pixel_of).out;
    }
    return result;
}

}  // namespace hyrax
