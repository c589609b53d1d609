-- MUST: kill | moving nils over 2^60 positions costs no memory
-- SPDX-License-Identifier: MIT
table.move({}, 1, 1 << 60, 1, {})
