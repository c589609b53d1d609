-- MUST: kill | next() scans an emptied hash part each time
-- SPDX-License-Identifier: MIT
local t = {}
for i = 1, 131072 do t["k" .. i] = i end
for k in pairs(t) do t[k] = nil end
while true do next(t) end
