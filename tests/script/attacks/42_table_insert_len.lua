-- MUST: kill | a lying __len makes table.insert shift 2^60 nils
-- SPDX-License-Identifier: MIT
table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, nil)
