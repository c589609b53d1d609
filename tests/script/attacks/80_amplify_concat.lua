-- MUST: kill | each .. copies the largest allowed string: VM instructions are not equal in cost
-- SPDX-License-Identifier: MIT
local a, b = ("x"):rep(500000), ("y"):rep(500000)
while true do local c = a .. b end
