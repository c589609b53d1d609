-- SPDX-License-Identifier: MIT
-- The best rounds, the best first, over restarts.
local scores = {}

local KEPT = 5

-- The place of these points in the list, nil if they are not among the best.
function scores.add(points)
  local best = hyrax.store.get("best", {})
  local place = 1
  while best[place] and best[place] >= points do place = place + 1 end
  if points == 0 or place > KEPT then return nil end
  table.insert(best, place, points)
  best[KEPT + 1] = nil
  hyrax.store.set("best", best)
  return place
end

function scores.text()
  local best = hyrax.store.get("best", {})
  return #best == 0 and "Throw a hyrax in!" or "Best: " .. table.concat(best, ", ")
end

return scores
