-- MUST: kill | the budget error cannot be swallowed by pcall in an outer endless loop
-- SPDX-License-Identifier: MIT
while true do pcall(function() while true do end end) end
