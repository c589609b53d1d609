-- MUST: kill | loading succeeds; the timer's first call must be killed
-- SPDX-License-Identifier: MIT
hyrax.every(0.01, function() while true do pcall(function() while true do end end) end end)
