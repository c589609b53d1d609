// SPDX-License-Identifier: MIT
//! Boxes in four walls, stepped by Rapier. `bench_peers_rapier.cpp` is the other side.

use rapier2d::prelude::*;

/// As `RapierBody` in C++: the centre [m] and the velocity [m/s].
#[repr(C)]
pub struct Body {
    x: f32,
    y: f32,
    vx: f32,
    vy: f32,
}

pub struct World {
    gravity: Vector,
    parameters: IntegrationParameters,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    soft_bodies: SoftBodySet,
    ccd: CCDSolver,
    handles: Vec<RigidBodyHandle>,
}

fn add_walls(colliders: &mut ColliderSet, width: f32, height: f32) {
    let corners = [
        Vector::new(0.0, 0.0),
        Vector::new(width, 0.0),
        Vector::new(width, height),
        Vector::new(0.0, height),
    ];
    for i in 0..4 {
        let wall = ColliderBuilder::segment(corners[i], corners[(i + 1) % 4])
            .friction(0.0)
            .restitution(1.0)
            .collision_groups(groups(Group::GROUP_1, Group::GROUP_2));
        colliders.insert(wall);
    }
}

fn groups(member: Group, meets: Group) -> InteractionGroups {
    InteractionGroups::new(member, meets, InteractionTestMode::And)
}

/// # Safety
/// `start` points to `count` bodies.
#[no_mangle]
pub unsafe extern "C" fn rapier_create(
    start: *const Body,
    count: usize,
    half_side: f32,
    width: f32,
    height: f32,
    gravity: f32,
    drag: f32,
    frame: f32,
) -> *mut World {
    let mut world = World {
        gravity: Vector::new(0.0, gravity),
        parameters: IntegrationParameters { dt: frame, ..Default::default() },
        pipeline: PhysicsPipeline::new(),
        islands: IslandManager::new(),
        broad_phase: DefaultBroadPhase::new(),
        narrow_phase: NarrowPhase::new(),
        bodies: RigidBodySet::new(),
        colliders: ColliderSet::new(),
        impulse_joints: ImpulseJointSet::new(),
        multibody_joints: MultibodyJointSet::new(),
        soft_bodies: SoftBodySet::new(),
        ccd: CCDSolver::new(),
        handles: Vec::with_capacity(count),
    };
    add_walls(&mut world.colliders, width, height);
    for body in std::slice::from_raw_parts(start, count) {
        let handle = world.bodies.insert(
            RigidBodyBuilder::dynamic()
                .translation(Vector::new(body.x, body.y))
                .linvel(Vector::new(body.vx, body.vy))
                .linear_damping(drag)
                .lock_rotations(),
        );
        // Boxes meet walls alone.
        let shape = ColliderBuilder::cuboid(half_side, half_side)
            .friction(0.0)
            .restitution(1.0)
            .collision_groups(groups(Group::GROUP_2, Group::GROUP_1));
        world.colliders.insert_with_parent(shape, handle, &mut world.bodies);
        world.handles.push(handle);
    }
    Box::into_raw(Box::new(world))
}

/// # Safety
/// `world` comes from `rapier_create`.
#[no_mangle]
pub unsafe extern "C" fn rapier_destroy(world: *mut World) {
    drop(Box::from_raw(world));
}

/// So many frames; the sum of all coordinates at each.
///
/// # Safety
/// `world` comes from `rapier_create`.
#[no_mangle]
pub unsafe extern "C" fn rapier_run(world: *mut World, frames: i32) -> f64 {
    let world = &mut *world;
    let mut sum = 0.0;
    for _ in 0..frames {
        world.pipeline.step(
            world.gravity,
            &world.parameters,
            &mut world.islands,
            &mut world.broad_phase,
            &mut world.narrow_phase,
            &mut world.bodies,
            &mut world.colliders,
            &mut world.impulse_joints,
            &mut world.multibody_joints,
            &mut world.soft_bodies,
            &mut world.ccd,
            &(),
            &(),
        );
        for &handle in &world.handles {
            let place = world.bodies[handle].translation();
            sum += f64::from(place.x + place.y);
        }
    }
    sum
}
