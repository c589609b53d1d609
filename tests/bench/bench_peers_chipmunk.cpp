// SPDX-License-Identifier: MIT
// Debian's Chipmunk, 7.
#include "tests/bench/bench_peers_engines.h"

#include <chipmunk/chipmunk.h>

#include <cmath>

namespace hyrax::bench {
namespace {

constexpr double half_side = peer_side / 2.0;
constexpr double drag = 0.06;  // [1/s]
constexpr double wall_radius = 10.0;
constexpr cpGroup all_bodies = 1;

class Chipmunk : public Peer {
public:
    explicit Chipmunk(const PeerScene& scene) : space_(cpSpaceNew()), start_(scene.bodies) {
        cpSpaceSetGravity(space_, cpv(0.0, 1200.0));
        cpSpaceSetDamping(space_, std::exp(-drag));
        make_walls(scene.screen);
        for (std::size_t i = 0; i < start_.size(); ++i) {
            // An infinite moment of inertia: it does not turn.
            cpBody* const body = cpSpaceAddBody(space_, cpBodyNew(1.0, INFINITY));
            cpShape* const shape =
                cpSpaceAddShape(space_, cpBoxShapeNew(body, peer_side, peer_side, 0.0));
            cpShapeSetElasticity(shape, 1.0);
            cpShapeSetFriction(shape, 0.0);
            // Never with one of the same group.
            cpShapeSetFilter(shape, {all_bodies, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES});
            bodies_.push_back(body);
            shapes_.push_back(shape);
        }
    }

    ~Chipmunk() override {
        for (cpShape* shape : shapes_) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        for (cpBody* body : bodies_) {
            cpSpaceRemoveBody(space_, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space_);
    }

    std::string name() const override { return std::string("Chipmunk ") + cpVersionString; }

    void reset() override {
        for (std::size_t i = 0; i < start_.size(); ++i) {
            const auto& [position, velocity] = start_[i];
            cpBodySetPosition(bodies_[i], cpv(position.x + half_side, position.y + half_side));
            cpBodySetVelocity(bodies_[i], cpv(velocity.x, velocity.y));
        }
    }

    double run(int frames) override {
        double sum = 0.0;
        for (; frames > 0; --frames) {
            cpSpaceStep(space_, peer_frame);
            for (const cpBody* body : bodies_) {
                const cpVect place = cpBodyGetPosition(body);
                sum += place.x + place.y;
            }
        }
        return sum;
    }

private:
    void make_walls(Size screen) {
        const cpFloat w = screen.width + wall_radius;
        const cpFloat h = screen.height + wall_radius;
        const cpVect corners[] = {
            cpv(-wall_radius, -wall_radius), cpv(w, -wall_radius), cpv(w, h), cpv(-wall_radius, h)
        };
        for (std::size_t i = 0; i < 4; ++i) {
            cpShape* const wall = cpSegmentShapeNew(
                cpSpaceGetStaticBody(space_), corners[i], corners[(i + 1) % 4], wall_radius
            );
            cpShapeSetElasticity(wall, 1.0);
            cpShapeSetFriction(wall, 0.0);
            shapes_.push_back(cpSpaceAddShape(space_, wall));
        }
    }

    cpSpace* space_;
    std::vector<PeerBody> start_;
    std::vector<cpBody*> bodies_;
    std::vector<cpShape*> shapes_;
};

}  // namespace

std::unique_ptr<Peer> make_chipmunk(const PeerScene& scene) {
    return std::make_unique<Chipmunk>(scene);
}

}  // namespace hyrax::bench
