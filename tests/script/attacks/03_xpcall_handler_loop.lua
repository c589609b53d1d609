-- MUST: kill | an xpcall message handler must not run script code for the budget error (it runs inside the hook, where hooks are off)
-- SPDX-License-Identifier: MIT
while true do xpcall(function() while true do end end, function() while true do end end) end
