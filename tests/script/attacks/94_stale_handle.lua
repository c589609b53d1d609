-- MUST: ok | a removed pet: valid is false, everything else is a clean error; the slot's next owner is not reached
-- SPDX-License-Identifier: MIT
local p = hyrax.spawn{ kind = "hyrax" }
local keep = p
assert(p.valid)
p:remove()
local q = hyrax.spawn{ kind = "hyrax" }
assert(not p.valid and q.valid and p ~= q)
assert(not pcall(function() return p.x end))
assert(not pcall(p.fling, p, 1, 1))
assert(pcall(p.remove, p))
assert(q.valid)
q:remove()
