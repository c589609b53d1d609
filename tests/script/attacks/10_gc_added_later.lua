-- MUST: ok | a __gc field added after setmetatable never runs
-- SPDX-License-Identifier: MIT
local ran = false
local mt = {}
for i = 1, 100 do setmetatable({}, mt) end
mt.__gc = function() ran = true end
for i = 1, 2e5 do local t = { i } end
assert(not ran)
