-- MUST: ok | NaN, inf, huge and wrong arguments never reach the physics
-- SPDX-License-Identifier: MIT
local p = hyrax.spawn{ kind = "hyrax" }
local nan, inf = 0 / 0, 1 / 0
assert(not pcall(p.fling, p, nan, 0))
assert(not pcall(p.fling, p, 0, nan))
assert(not pcall(p.fling, p, inf, 0))
assert(not pcall(p.fling, p, -inf, 0))
assert(not pcall(p.fling, p, "abc", 0))
assert(not pcall(p.fling, p, {}, 0))
assert(not pcall(p.fling, p))
assert(pcall(p.fling, p, 1e300, -1e300))          -- clamped
assert(math.abs(p.vx) <= 20000 and math.abs(p.vy) <= 20000)
assert(not pcall(hyrax.spawn, { kind = ("x"):rep(1e5) }))
assert(not pcall(hyrax.spawn, { x = nan }))
assert(not pcall(hyrax.spawn, 42))
assert(not pcall(hyrax.every, nan, print))
assert(not pcall(hyrax.every, 1, nil))
p:remove()
