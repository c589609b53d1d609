// SPDX-License-Identifier: MIT
#include "tests/bench/bench_throughput.h"

#include "physics/batch.h"
#include "tests/support/batch_identity.h"

#include <immintrin.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iomanip>
#include <ostream>
#include <string>
#include <utility>

namespace hyrax {

namespace {

// A scene that never comes to rest, where the class mispredicts few branches and where speeds
// neither become subnormal nor grow. The operations are the same with any constants.
constexpr PhysicsConstants billiards{
    .gravity = 0.0,
    .restitution = 1.0,
    .air_drag = 1.0,
    .ground_friction = 1.0,
    .rest_threshold = 0.0,
};
constexpr DocumentFrame full_hd{.dt = 1.0 / 60.0, .screen = {1920, 1080}, .object = {128, 128}};

constexpr std::array<std::size_t, 6> numbers_of_pets{1, 100, 1000, 10'000, 100'000, 1'000'000};
// Short beside the time slices of a system, so that most samples run undisturbed on a busy machine.
constexpr double seconds_per_sample = 0.001;
constexpr std::size_t fewest_samples = 15;

// Changes the sign of every number, by the widest vectors: a load and a store of each, with the
// cheapest operation that a compiler cannot leave out. No step of four numbers can be quicker.
class FourStreams {
public:
    explicit FourStreams(std::size_t pets) : pets_(pets) {
        for (std::size_t i = 0; i < pets; ++i) {
            for (BatchColumn* column : {&a_, &b_, &c_, &d_}) {
                column->make_room(i);
            }
        }
    }

    void run(long steps) {
        for (; steps > 0; --steps) {
            switch (best_kernel()) {
                case Kernel::avx512:
                    negate_avx512(a_.data(), b_.data(), c_.data(), d_.data(), pets_);
                    break;
                case Kernel::avx2:
                    negate_avx2(a_.data(), b_.data(), c_.data(), d_.data(), pets_);
                    break;
                default:
                    negate_sse2(a_.data(), b_.data(), c_.data(), d_.data(), pets_);
            }
        }
    }

private:
    using Numbers = double*;

    static void negate_sse2(Numbers a, Numbers b, Numbers c, Numbers d, std::size_t count) {
        const __m128d sign = _mm_set1_pd(-0.0);
        for (std::size_t i = 0; i < count; i += 2) {
            _mm_storeu_pd(a + i, _mm_xor_pd(_mm_loadu_pd(a + i), sign));
            _mm_storeu_pd(b + i, _mm_xor_pd(_mm_loadu_pd(b + i), sign));
            _mm_storeu_pd(c + i, _mm_xor_pd(_mm_loadu_pd(c + i), sign));
            _mm_storeu_pd(d + i, _mm_xor_pd(_mm_loadu_pd(d + i), sign));
        }
    }
    [[gnu::target("avx2")]] static void negate_avx2(
        Numbers a, Numbers b, Numbers c, Numbers d, std::size_t count
    ) {
        const __m256d sign = _mm256_set1_pd(-0.0);
        for (std::size_t i = 0; i < count; i += 4) {
            _mm256_storeu_pd(a + i, _mm256_xor_pd(_mm256_loadu_pd(a + i), sign));
            _mm256_storeu_pd(b + i, _mm256_xor_pd(_mm256_loadu_pd(b + i), sign));
            _mm256_storeu_pd(c + i, _mm256_xor_pd(_mm256_loadu_pd(c + i), sign));
            _mm256_storeu_pd(d + i, _mm256_xor_pd(_mm256_loadu_pd(d + i), sign));
        }
    }
    // Foundation AVX-512 has no xor of doubles.
    [[gnu::target("avx512f")]] static void negate_avx512(
        Numbers a, Numbers b, Numbers c, Numbers d, std::size_t count
    ) {
        const __m512i sign = _mm512_castpd_si512(_mm512_set1_pd(-0.0));
        for (std::size_t i = 0; i < count; i += 8) {
            _mm512_storeu_si512(a + i, _mm512_xor_si512(_mm512_loadu_si512(a + i), sign));
            _mm512_storeu_si512(b + i, _mm512_xor_si512(_mm512_loadu_si512(b + i), sign));
            _mm512_storeu_si512(c + i, _mm512_xor_si512(_mm512_loadu_si512(c + i), sign));
            _mm512_storeu_si512(d + i, _mm512_xor_si512(_mm512_loadu_si512(d + i), sign));
        }
    }

    std::size_t pets_;
    BatchColumn a_, b_, c_, d_;
};

struct Contender {
    std::string title;
    std::function<void(long steps)> run;
    long steps_per_sample = 1;
    std::vector<double> seconds{};  ///< Of one step, for each sample.

    double median() {
        const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
        std::nth_element(seconds.begin(), middle, seconds.end());
        return *middle;
    }
};

double seconds_of(const Contender& contender, long steps) {
    const auto begin = std::chrono::steady_clock::now();
    contender.run(steps);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<Contender> contenders_for(std::size_t pets) {
    DocumentBatch batch(billiards);
    DocumentTwins twins(billiards);
    RandomBits random(1);
    for (std::size_t i = 0; i < pets; ++i) {
        const DocumentState body{
            .x = random.between(0.0, 1792.0),
            .y = random.between(0.0, 952.0),
            .vx = random.between(-1000.0, 1000.0),
            .vy = random.between(-1000.0, 1000.0),
        };
        batch.push_back(body);
        twins.push_back(body);
    }

    std::vector<Contender> made;
    const auto run_class = [twins = std::move(twins)](long steps) mutable {
        for (; steps > 0; --steps) {
            twins.step(full_hd);
        }
    };
    made.push_back({.title = "class", .run = run_class});
    for (const Kernel kernel : available_kernels()) {
        const auto run_batch = [batch, kernel](long steps) mutable {
            for (; steps > 0; --steps) {
                batch.step(full_hd, kernel);
            }
        };
        made.push_back({.title = std::string(name(kernel)), .run = run_batch});
    }
    const auto run_memory = [streams = FourStreams(pets)](long steps) mutable {
        streams.run(steps);
    };
    made.push_back({.title = "memory", .run = run_memory});
    return made;
}

// Turn by turn, so that another load of the machine slows all of them and leaves the ratios.
void measure(std::vector<Contender>& contenders, double seconds_per_cell) {
    for (Contender& contender : contenders) {
        while (seconds_of(contender, contender.steps_per_sample) < seconds_per_sample) {
            contender.steps_per_sample *= 2;
        }
    }
    const double enough = seconds_per_cell * static_cast<double>(contenders.size());
    double spent = 0.0;
    for (std::size_t sample = 0; sample < fewest_samples || spent < enough; ++sample) {
        for (Contender& contender : contenders) {
            contender.run(1);  // brings its bodies back into the caches
            const double seconds = seconds_of(contender, contender.steps_per_sample);
            contender.seconds.push_back(seconds / static_cast<double>(contender.steps_per_sample));
            spent += seconds;
        }
    }
}

}  // namespace

void throughput(std::ostream& table, std::ostream& csv, double seconds_per_cell) {
    table << "ns per pet and step (how many times as fast as the class)\n" << std::fixed;
    csv << "pets,kernel,ns_per_pet_and_step,times_as_fast_as_class\n";
    bool titled = false;
    for (const std::size_t pets : numbers_of_pets) {
        std::vector<Contender> contenders = contenders_for(pets);
        if (!titled) {
            table << std::setw(8) << "pets";
            for (const Contender& contender : contenders) {
                table << std::setw(17) << contender.title;
            }
            table << '\n';
            titled = true;
        }
        measure(contenders, seconds_per_cell);
        const double of_class = contenders.front().median();
        table << std::setw(8) << pets;
        for (Contender& contender : contenders) {
            const double nanoseconds = contender.median() * 1e9 / static_cast<double>(pets);
            const double ratio = of_class / contender.median();
            table << std::setprecision(3) << std::setw(9) << nanoseconds << " (" << std::setw(5)
                  << std::setprecision(1) << ratio << ")";
            csv << pets << ',' << contender.title << ',' << nanoseconds << ',' << ratio << '\n';
        }
        table << '\n' << std::flush;
    }
}

}  // namespace hyrax
