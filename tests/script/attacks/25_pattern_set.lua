-- MUST: kill | long character sets multiply the cost of each character
-- SPDX-License-Identifier: MIT
local set = "[" .. ("b"):rep(400000) .. "]"
local s = ("a"):rep(400000)
s:find(set)
