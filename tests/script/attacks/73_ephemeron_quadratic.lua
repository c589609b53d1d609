-- MUST: ok | zig-zag ephemeron chain: stock GC needs seconds in one atomic step (HOST: weak keys are strong, no stall over 150 ms)
-- SPDX-License-Identifier: MIT
local N = 30000
if not hyrax then N = 60000 end
local keys = {} for i = 1, N + 1 do keys[i] = {} end
local mt = {}
mt.__mode = nil
local byidx = {}
for i = 1, N do byidx[i] = setmetatable({ [keys[i]] = keys[i + 1] }, mt) end
rawset(mt, "__mode", "k")
local tabs, lo, hi = {}, 1, N
for i = 1, N do if i % 2 == 1 then tabs[lo] = byidx[i] lo = lo + 1 else tabs[hi] = byidx[i] hi = hi - 1 end end
byidx = nil
local first = keys[1] keys = nil
for i = 1, 3e5 do local t = {} end
