-- MUST: error: | 30000 labels: checking repeated labels is quadratic (source text limit / charged)
-- SPDX-License-Identifier: MIT
local t = {}
for i = 1, 30000 do t[i] = "::a" .. i .. "::" end
local f = assert(load(table.concat(t)))
error("accepted")
