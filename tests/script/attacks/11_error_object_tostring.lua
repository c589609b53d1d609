-- MUST: error: | a hostile error object must not run script code in the host's error report
-- SPDX-License-Identifier: MIT
error(setmetatable({}, { __tostring = function() while true do end end, __name = ("x"):rep(1e5) }))
