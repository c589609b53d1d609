-- MUST: error:stack overflow | recursion through C (gsub callback)
-- SPDX-License-Identifier: MIT
local function f() return (("x"):gsub("x", f)) end
f()
