-- MUST: error: | load with a reader function that never ends
-- SPDX-License-Identifier: MIT
local f = assert(load(function() return "local a = 1 " end))
error("accepted")
