-- MUST: kill | sorting 2^31 nils with a C comparator (math.type gives nil): no VM instruction, no memory
-- SPDX-License-Identifier: MIT
table.sort(setmetatable({}, { __len = function() return (1 << 31) - 2 end }), math.type)
