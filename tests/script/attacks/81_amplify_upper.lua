-- MUST: kill | O(n) C calls in a loop
-- SPDX-License-Identifier: MIT
local a = ("x"):rep(1000000)
while true do local c = a:upper() end
