---@meta hyrax
-- SPDX-License-Identifier: MIT
-- What a script sees, for editors that know LuaLS. Lengths are physical pixels of the virtual
-- desktop, y grows downwards, time is seconds, speed is px/s. Wrong arguments raise an error that
-- names the argument; so does reaching a limit.
--
-- Beside `hyrax` and `print`, scripts have Lua's own assert collectgarbage("count") error
-- getmetatable ipairs load next pairs pcall rawequal rawget rawlen rawset require select setmetatable
-- tonumber tostring type xpcall coroutine math string table utf8, os.clock os.difftime os.time and
-- debug.traceback. Tables are never weak, and there are no finalizers.

---@alias hyrax.EventName
---| "ready"    # fun()                                all scripts are loaded
---| "tick"     # fun(dt: number)                      at most 60 times a second; dt: since the last one
---| "spawn"    # fun(pet: hyrax.Pet)
---| "remove"   # fun(pet: hyrax.Pet)                  pet.valid is already false, pet.id and pet.tag still read
---| "grab"     # fun(pet: hyrax.Pet)                  the user picked it up
---| "throw"    # fun(pet: hyrax.Pet, vx: number, vy: number)   the user let it go
---| "bounce"   # fun(pet: hyrax.Pet, side: "left"|"right"|"top"|"bottom", speed: number)
---| "land"     # fun(pet: hyrax.Pet, speed: number)   the first touch of the floor after a flight
---| "click"    # fun(pet: hyrax.Pet, button: "left"|"right"|"middle")
---| "monitors" # fun()                                screens came or went

---@class hyrax.Pet                 a handle; the same pet is always the same handle, so it can be a key of a table
---@field readonly valid boolean    false once the pet is gone; only valid, id and tag can be read then
---@field readonly id integer
---@field readonly kind string
---@field readonly owner string     the script's file name, or "user"
---@field readonly x number         left edge of its box
---@field readonly y number         top edge of its box
---@field readonly vx number
---@field readonly vy number
---@field readonly w integer
---@field readonly h integer
---@field readonly state "fall"|"idle"|"held"
---@field tag string                free text, at most 64 bytes, survives a reload
---@field readonly facing "left"|"right"
local Pet = {}
---Sets the velocity, as if thrown by hand. Longer ones than 20000 px/s are shortened.
---@param vx number
---@param vy number
function Pet:fling(vx, vy) end
---Adds to the velocity.
---@param dvx number
---@param dvy number
function Pet:push(dvx, dvy) end
---Both velocity components become zero.
function Pet:stop() end
---Back to where it was spawned, at rest.
function Pet:reset() end
---Puts its top-left corner there, or as near as the screens allow.
---@param x number
---@param y number
function Pet:move_to(x, y) end
---Safe to call twice.
function Pet:remove() end
---Like hyrax.on, for this pet alone. Ends with the pet.
---@param event hyrax.EventName     one that is about a pet
---@param fn function
---@return hyrax.Subscription
function Pet:on(event, fn) end

---@class hyrax.Subscription
local Subscription = {}
---Ends the handler or timer. Safe to call twice.
function Subscription:cancel() end

---@class hyrax.SpawnOptions
---@field kind? string      default "hyrax"
---@field x? number         default: somewhere on a screen
---@field y? number         default: the top of that screen
---@field vx? number        default 0
---@field vy? number        default 0
---@field tag? string       default ""

---@class hyrax.Near        a circle; a pet is in it if the middle of its box is
---@field x number
---@field y number
---@field r number

---@class hyrax.PetFilter
---@field kind? string
---@field tag? string
---@field all? boolean      pets of other owners, too
---@field near? hyrax.Near

---@class hyrax.Rect
---@field x number
---@field y number
---@field w number
---@field h number

---@class hyrax.Monitor: hyrax.Rect
---@field work hyrax.Rect   without the taskbar
---@field primary boolean

---@class hyrax
---@field readonly api string        "1.0"
---@field log hyrax.Log
hyrax = {}
---@param opts? hyrax.SpawnOptions
---@return hyrax.Pet    raises an error when this script has 64 pets
function hyrax.spawn(opts) end
---Own pets, the topmost last.
---@param filter? hyrax.PetFilter
---@return hyrax.Pet[]
function hyrax.pets(filter) end
---The topmost pet whose box holds the point.
---@param x number
---@param y number
---@return hyrax.Pet?
function hyrax.pet_at(x, y) end
---Sets the velocity of every pet that hyrax.pets(filter) lists.
---@param filter hyrax.PetFilter?
---@param vx number
---@param vy number
function hyrax.fling(filter, vx, vy) end
---Every pet back to where it was spawned, at rest.
function hyrax.reset() end
---Removes every pet.
function hyrax.clear() end
---@param event hyrax.EventName
---@param fn function     runs in its own coroutine: it may wait()
---@return hyrax.Subscription
function hyrax.on(event, fn) end
---Calls fn once.
---@param seconds number  0 or more; not sooner than 1/120
---@param fn function
---@return hyrax.Subscription  goes on whether or not the result is kept
function hyrax.after(seconds, fn) end
---Calls fn again and again. After a pause it goes on without making up for what it missed.
---@param seconds number  at least 1/120
---@param fn function
---@return hyrax.Subscription
function hyrax.every(seconds, fn) end
---Starts fn now, in its own coroutine. Its errors go to the log, not to the caller.
---@param fn function
---@param ... any         arguments of fn
function hyrax.task(fn, ...) end
---Not inside a sort comparator, a gsub callback or a metamethod.
---@async
---@param seconds number  0 or more; not shorter than 1/120
---@return number waited
function hyrax.wait(seconds) end
---@async
---@param pet hyrax.Pet
---@param event hyrax.EventName
---@param timeout? number
---@return any ...   what the event tells beside the pet (true if that is nothing); nil after the timeout or when the pet is gone
function hyrax.wait_for(pet, event, timeout) end
---@return number  seconds since this script was loaded, constant within one callback
function hyrax.now() end
---@return hyrax.Rect    what holds the work areas of all screens
function hyrax.arena() end
---@return hyrax.Monitor[]
function hyrax.monitors() end

---@class hyrax.Log      50 lines a second, 512 bytes a line
local Log = {}
---@param fmt any        with further arguments a format as in string.format, else a value
---@param ... any
function Log.info(fmt, ...) end
---@param fmt any
---@param ... any
function Log.warn(fmt, ...) end
---@param fmt any
---@param ... any
function Log.error(fmt, ...) end
return hyrax
