-- MUST: error:limit | at most 64 pets per plugin
-- SPDX-License-Identifier: MIT
for i = 1, 1e6 do hyrax.spawn{ kind = "hyrax" } end
