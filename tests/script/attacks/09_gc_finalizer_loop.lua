-- MUST: error:__gc | finalizers run with hooks disabled: scripts may not have any
-- SPDX-License-Identifier: MIT
setmetatable({}, { __gc = function() while true do end end })
collectgarbage("collect")
for i = 1, 1e6 do local t = {} end
