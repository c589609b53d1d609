// SPDX-License-Identifier: MIT
// Debian's Box2D, 2.4.
#include "tests/bench/bench_peers_engines.h"

#include <box2d/box2d.h>
#include <fmt/format.h>

namespace hyrax::bench {
namespace {

// Box2D is made for bodies of 0.1 to 10 m.
constexpr float pixels_per_meter = 100.0F;
constexpr float half_side = peer_side / 2.0F / pixels_per_meter;
constexpr float gravity = 1200.0F / pixels_per_meter;
constexpr float drag = 0.06F;  // [1/s]
// What its manual recommends.
constexpr int velocity_iterations = 8;
constexpr int position_iterations = 3;

float meters(double pixels) {
    return static_cast<float>(pixels) / pixels_per_meter;
}

class Box2d : public Peer {
public:
    explicit Box2d(const PeerScene& scene) : world_({0.0F, gravity}), start_(scene.bodies) {
        make_walls(scene.screen);
        b2PolygonShape box;
        box.SetAsBox(half_side, half_side);
        for (std::size_t i = 0; i < start_.size(); ++i) {
            b2BodyDef definition;
            definition.type = b2_dynamicBody;
            definition.fixedRotation = true;
            definition.linearDamping = drag;
            b2Body* const body = world_.CreateBody(&definition);
            b2FixtureDef fixture;
            fixture.shape = &box;
            fixture.density = 1.0F;
            fixture.friction = 0.0F;
            fixture.restitution = 1.0F;
            fixture.filter.groupIndex = -1;  // Never with one of the same group.
            body->CreateFixture(&fixture);
            bodies_.push_back(body);
        }
    }

    std::string name() const override {
        return fmt::format("Box2D {}.{}", b2_version.major, b2_version.minor);
    }

    void reset() override {
        for (std::size_t i = 0; i < start_.size(); ++i) {
            const auto& [position, velocity] = start_[i];
            const b2Vec2 center{meters(position.x) + half_side, meters(position.y) + half_side};
            bodies_[i]->SetTransform(center, 0.0F);
            bodies_[i]->SetLinearVelocity({meters(velocity.x), meters(velocity.y)});
            bodies_[i]->SetAwake(true);
        }
    }

    double run(int frames) override {
        double sum = 0.0;
        for (; frames > 0; --frames) {
            world_.Step(static_cast<float>(peer_frame), velocity_iterations, position_iterations);
            for (const b2Body* body : bodies_) {
                const b2Vec2& place = body->GetPosition();
                sum += static_cast<double>(place.x + place.y);
            }
        }
        return sum;
    }

private:
    void make_walls(Size screen) {
        const float width = meters(screen.width);
        const float height = meters(screen.height);
        const b2Vec2 corners[] = {{0.0F, 0.0F}, {width, 0.0F}, {width, height}, {0.0F, height}};
        const b2BodyDef definition;
        b2Body* const ground = world_.CreateBody(&definition);
        for (std::size_t i = 0; i < 4; ++i) {
            b2EdgeShape edge;
            edge.SetTwoSided(corners[i], corners[(i + 1) % 4]);
            ground->CreateFixture(&edge, 0.0F);
        }
    }

    b2World world_;
    std::vector<PeerBody> start_;
    std::vector<b2Body*> bodies_;
};

}  // namespace

std::unique_ptr<Peer> make_box2d(const PeerScene& scene) {
    return std::make_unique<Box2d>(scene);
}

}  // namespace hyrax::bench
