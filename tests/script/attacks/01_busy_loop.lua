-- MUST: kill | plain endless loop is stopped by the budget
-- SPDX-License-Identifier: MIT
while true do end
