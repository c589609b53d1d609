-- MUST: error:not enough memory | s = s .. s
-- SPDX-License-Identifier: MIT
local s = "x"
while true do s = s .. s end
