// SPDX-License-Identifier: MIT
#include "physics/batch.h"
#include "physics/trajectory.h"
#include "tests/bench/bench_peers_engines.h"
#include "tests/bench/meter.h"
#include "tests/support/batch_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace hyrax::bench {
namespace {

constexpr int frames = 60;
constexpr int fewest_samples = 5;
constexpr std::size_t numbers_of_bodies[] = {100, 1000, 10'000};
constexpr Size screen_of_100{1920, 1080};
// Impacts that keep all speed: nobody comes to rest, here and in the engines.
constexpr PhysicsConstants lasting{.restitution = 1.0, .ground_friction = 1.0};

class EventDriven : public Peer {
public:
    explicit EventDriven(const PeerScene& scene)
        : law_(law_from(lasting)),
          space_(FreeSpace::box(
              0.0, 0.0, scene.screen.width - peer_side, scene.screen.height - peer_side
          )) {
        for (const auto& [position, velocity] : scene.bodies) {
            start_.emplace_back().launch(0, position, velocity, law_, space_);
        }
    }
    std::string name() const override { return "hyrax event_driven"; }
    void reset() override { bodies_ = start_; }
    double run(int steps) override {
        double sum = 0.0;
        for (int frame = 1; frame <= steps; ++frame) {
            const Ticks now = frame * ticks_per_second / 60;
            for (Trajectory& body : bodies_) {
                body.advance(now, law_, space_, [](const TrajectoryEvent&) {});
                const Vec2 place = body.position(now, law_, space_);
                sum += place.x + place.y;
            }
        }
        return sum;
    }

private:
    Law law_;
    FreeSpace space_;
    std::vector<Trajectory> start_;
    std::vector<Trajectory> bodies_;
};

class DocumentClass : public Peer {
public:
    explicit DocumentClass(const PeerScene& scene) : screen_(scene.screen) {
        for (const auto& [p, v] : scene.bodies) {
            start_.emplace_back(p.x, p.y, v.x, v.y).setConstants(lasting);
        }
    }
    std::string name() const override { return "hyrax, the document's class"; }
    void reset() override { bodies_ = start_; }
    double run(int steps) override {
        double sum = 0.0;
        for (; steps > 0; --steps) {
            for (physics& body : bodies_) {
                body.update(peer_frame, screen_.width, screen_.height, peer_side, peer_side);
                sum += body.x() + body.y();
            }
        }
        return sum;
    }

private:
    std::vector<physics> start_;
    std::vector<physics> bodies_;
    Size screen_;
};

class DocumentBatchPeer : public Peer {
public:
    explicit DocumentBatchPeer(const PeerScene& scene) : start_(lasting), screen_(scene.screen) {
        for (const auto& [p, v] : scene.bodies) {
            start_.push_back({p.x, p.y, v.x, v.y});
        }
        bodies_ = start_;
    }
    std::string name() const override { return "hyrax, the document's batch"; }
    void reset() override { bodies_ = start_; }
    double run(int steps) override {
        const DocumentFrame frame{
            .dt = peer_frame, .screen = screen_, .object = {peer_side, peer_side}
        };
        for (; steps > 0; --steps) {
            bodies_.step(frame);
        }
        // Who draws takes them from where they are.
        return bodies_.get(0).x;
    }

private:
    DocumentBatch start_;
    DocumentBatch bodies_;
    Size screen_;
};

std::vector<std::unique_ptr<Peer>> contenders(std::size_t count) {
    RandomBits random(7);
    const double scale = std::sqrt(static_cast<double>(count) / 100.0);
    PeerScene scene{
        {static_cast<int>(screen_of_100.width * scale),
         static_cast<int>(screen_of_100.height * scale)},
        std::vector<PeerBody>(count)
    };
    const double right = scene.screen.width - peer_side - 1.0;
    const double bottom = scene.screen.height - peer_side - 1.0;
    for (auto& [position, velocity] : scene.bodies) {
        position = {random.between(1.0, right), random.between(1.0, bottom)};
        velocity = {random.between(-900.0, 900.0), random.between(-900.0, 900.0)};
    }
    std::vector<std::unique_ptr<Peer>> made;
    made.push_back(std::make_unique<EventDriven>(scene));
    made.push_back(std::make_unique<DocumentBatchPeer>(scene));
    made.push_back(std::make_unique<DocumentClass>(scene));
    for (const auto make_engine : {make_box2d, make_chipmunk, make_rapier}) {
        if (std::unique_ptr<Peer> engine = make_engine(scene)) {
            made.push_back(std::move(engine));
        }
    }
    return made;
}

double seconds_of(Peer& peer) {
    peer.reset();
    keep(peer.run(1));
    const auto begin = std::chrono::steady_clock::now();
    keep(peer.run(frames));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Turn by turn, so that another load of the machine slows all of them; the fastest sample of each.
std::vector<double> measure(std::vector<std::unique_ptr<Peer>>& all, double seconds_per_cell) {
    std::vector<double> fastest(all.size(), std::numeric_limits<double>::infinity());
    double spent = 0.0;
    const double enough = seconds_per_cell * static_cast<double>(all.size());
    for (int sample = 0; sample < fewest_samples || spent < enough; ++sample) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double seconds = seconds_of(*all[i]);
            spent += seconds;
            fastest[i] = std::min(fastest[i], seconds);
        }
    }
    return fastest;
}

}  // namespace

void peers(std::ostream& table, std::ostream& csv, double seconds_per_cell) {
    Progress progress("peers", std::size(numbers_of_bodies));
    csv << "bodies,engine,ns_per_body_and_step,times_event_driven\n";
    for (const std::size_t count : numbers_of_bodies) {
        std::vector<std::unique_ptr<Peer>> all = contenders(count);
        const std::vector<double> seconds = measure(all, seconds_per_cell);
        table << fmt::format(
            "\n{} boxes in four walls, no pair collisions, 60 Hz\n{:<32}{:>24}{:>22}\n",
            count,
            "engine",
            "ns per body and step",
            "times event_driven"
        );
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double ns = seconds[i] * 1e9 / (static_cast<double>(count) * frames);
            const double ratio = seconds[i] / seconds[0];
            table << fmt::format("{:<32}{:>24.2f}{:>22.2f}\n", all[i]->name(), ns, ratio);
            csv << fmt::format("{},\"{}\",{:.4g},{:.4g}\n", count, all[i]->name(), ns, ratio);
        }
        table << std::flush;
        progress.step();
    }
}

}  // namespace hyrax::bench
