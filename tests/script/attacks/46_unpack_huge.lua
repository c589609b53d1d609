-- MUST: error:too many results | unpack of a huge range
-- SPDX-License-Identifier: MIT
table.unpack({}, 1, 1e8)
