-- MUST: ok | Lua <= 5.4.8: assignment through a metatable that is its own __newindex misses a GC barrier (use after free)
-- SPDX-License-Identifier: MIT
for r = 1, 200 do
  local mt = {}
  mt.__newindex = mt
  for i = 1, 50 do
    local t = setmetatable({}, mt)
    t.__newindex = { "payload" .. i .. r }   -- overwrites the slot holding mt itself
    mt.__newindex = mt
    local junk = {} for j = 1, 20 do junk[j] = { j } end
  end
end
