// SPDX-License-Identifier: MIT
// Rapier, built from the crate in rapier/.
#include "tests/bench/bench_peers_engines.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

struct RapierWorld;

struct RapierBody {
    float x;
    float y;
    float vx;
    float vy;
};

// rapier/src/lib.rs
extern "C" {
RapierWorld* rapier_create(
    const RapierBody* start,
    std::size_t count,
    float half_side,
    float width,
    float height,
    float gravity,
    float drag,
    float frame
);
void rapier_destroy(RapierWorld* world);
double rapier_run(RapierWorld* world, std::int32_t frames);
}

namespace hyrax::bench {
namespace {

struct Destroy {
    void operator()(RapierWorld* world) const { rapier_destroy(world); }
};

// Rapier is made for bodies of about 1 m.
constexpr float pixels_per_meter = 100.0F;
constexpr float half_side = peer_side / 2.0F / pixels_per_meter;
constexpr float gravity = 1200.0F / pixels_per_meter;
constexpr float drag = 0.06F;  // [1/s]

float meters(double pixels) {
    return static_cast<float>(pixels) / pixels_per_meter;
}

class Rapier : public Peer {
public:
    explicit Rapier(const PeerScene& scene) : screen_(scene.screen) {
        for (const auto& [position, velocity] : scene.bodies) {
            start_.push_back({
                meters(position.x) + half_side,
                meters(position.y) + half_side,
                meters(velocity.x),
                meters(velocity.y),
            });
        }
    }

    std::string name() const override { return "Rapier 0.36"; }

    void reset() override {
        world_.reset(rapier_create(
            start_.data(),
            start_.size(),
            half_side,
            meters(screen_.width),
            meters(screen_.height),
            gravity,
            drag,
            static_cast<float>(peer_frame)
        ));
    }

    double run(int frames) override { return rapier_run(world_.get(), frames); }

private:
    std::vector<RapierBody> start_;
    Size screen_;
    std::unique_ptr<RapierWorld, Destroy> world_;
};

}  // namespace

std::unique_ptr<Peer> make_rapier(const PeerScene& scene) {
    return std::make_unique<Rapier>(scene);
}

}  // namespace hyrax::bench
