---@meta hyrax
-- SPDX-License-Identifier: MIT
-- What a script sees, for editors that know LuaLS. Lengths are physical pixels of the virtual
-- desktop, y grows downwards, time is seconds, speed is px/s. Wrong arguments raise an error that
-- names the argument; so does reaching a limit.
--
-- Beside `hyrax` and `print`, scripts have Lua's own assert collectgarbage("count") error
-- getmetatable ipairs load next pairs pcall rawequal rawget rawlen rawset require select setmetatable
-- tonumber tostring type xpcall coroutine math string table utf8, os.clock os.difftime os.time and
-- debug.traceback. `require` finds "hyrax", and in a plugin its own Lua files: "lib.score" is
-- lib/score.lua. Tables are never weak, and there are no finalizers.

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
---| "collide"  # fun(a: hyrax.Pet, b: hyrax.Pet, speed: number)   their boxes begin to overlap; speed: how fast they came nearer. With pet:on, a is that pet
---| "monitors" # fun()                                screens came or went
---| "config"   # fun(key: string, value: any)         the user changed a setting of this script
---| "unload"   # fun(reason: "reload"|"disable"|"exit")   the last that is heard: a small budget, no waiting

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
---@field readonly state "fall"|"idle"|"walk"|"held"
---@field tag string                free text, at most 64 bytes, survives a reload
---@field scale number              its own, 0.25 to 4; the feet stay where they are
---@field facing "left"|"right"     a pet that moves turns to where it goes
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
---Walks along the floor, once it is on one, until its left edge is at x; a wall, the edge of the
---floor, a hand or another verb ends the walk before.
---@param x number
---@param speed? number             1 to 20000, default 120
function Pet:walk_to(x, speed) end
---Shows an animation of its kind: once or, if it loops, until the pet is grabbed or set in motion.
---@param animation string
---@param opts? hyrax.PlayOptions
function Pet:play(animation, opts) end
---Shows a bubble above the pet, of three lines at most. An empty text takes it away.
---@param text string               at most 200 bytes, plain text
---@param seconds? number           0.1 to 3600, default 3
function Pet:say(text, seconds) end
---Safe to call twice.
function Pet:remove() end
---Like hyrax.on, for this pet alone. Ends with the pet.
---@param event hyrax.EventName     one that is about a pet
---@param fn function
---@return hyrax.Subscription
function Pet:on(event, fn) end

---@class hyrax.Subscription
local Subscription = {}
---Ends the handler, timer or hotkey. Safe to call twice.
function Subscription:cancel() end

---@class hyrax.SpawnOptions
---@field kind? string      default "hyrax"; a plugin's own kind by its name, others' as "<plugin>/<kind>"
---@field x? number         default: somewhere on a screen
---@field y? number         default: the top of that screen
---@field vx? number        default 0
---@field vy? number        default 0
---@field tag? string       default ""
---@field scale? number     0.25 to 4, default 1

---@class hyrax.PlayOptions
---@field loop? boolean     default: as the animation is made
---@field fps? number       0.1 to 120; default: as its frames last

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
---@field scale number      how much larger things are shown there: 1.5 at 150 %

---@class hyrax.Plugin
---@field readonly id string         the script's file name, or the plugin's id
---@field readonly version string    "" for a script

---@class hyrax
---@field readonly api string        "1.0"
---@field readonly plugin hyrax.Plugin
---@field readonly config table<string, any>   the user's settings of this script
---@field store hyrax.Store
---@field log hyrax.Log
---@field test? hyrax.Test           only where tests run: hyrax-headless --test
hyrax = {}
---@param opts? hyrax.SpawnOptions
---@return hyrax.Pet    raises an error when this script has 64 pets
function hyrax.spawn(opts) end
---Own pets, the topmost last. Those of others can be read; changing them needs the permission
---"pets.others".
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
---Own pets, and with the permission "pets.others" all, back to where they were spawned, at rest.
function hyrax.reset() end
---Removes own pets, and with the permission "pets.others" all.
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

---Where the pointer is; nil while that is not known. Looked for before each run of the scripts, if the
---script's text contains the word `cursor`. Needs the permission "cursor".
---@return number? x
---@return number? y
function hyrax.cursor() end
---The rectangles of other programs' windows, the topmost first, as they were within the last 0.1 s. Read
---if the script's text contains the word `windows`. Needs the permission "windows".
---@return hyrax.Rect[]
function hyrax.windows() end
---Calls fn when the keys are pressed, in whatever program. At most 16 at a time; keys that somebody else
---has are told in the log, and never come. Nothing is heard while hyrax is paused. Needs the permission
---"hotkeys".
---@param keys string       such as "ctrl+alt+h" or "f8"
---@param label string      what it does, for the user; at most 64 bytes
---@param fn function
---@return hyrax.Subscription
function hyrax.hotkey(keys, label, fn) end
---Tells the user something, at most once in 30 s: a balloon at the tray with the script's name, and a line
---in the log. No balloon while hyrax is quiet or hidden, or a program fills a screen. Needs the permission
---"notify".
---@param text string       at most 200 bytes, plain text
function hyrax.notify(text) end

---Air that moves [px/s], until another call: drag, and nothing else, pulls who flies along. The
---winds of several scripts add up; a script's ends with it. Needs the permission "wind".
---@param vx? number        nil, or two zeros, ends it
---@param vy? number        default 0
function hyrax.wind(vx, vy) end

---@class hyrax.Store    256 KiB; written to the disk in the background
local Store = {}
---A copy of what is kept under the key.
---@generic T
---@param key string      1 to 64 bytes
---@param default? T      if there is nothing
---@return T
function Store.get(key, default) end
---Keeps a copy from now on, over restarts.
---@param key string
---@param value any       nil (forgets it), a boolean, a number, a string in UTF-8, or a plain table of these: a list or names
function Store.set(key, value) end

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

---@class hyrax.Test     what `hyrax-headless --test script.lua` runs
local Test = {}
---A case of its own coroutine, run after the main chunk, one after the other. Any error of the
---script meanwhile fails it; its pets are removed when it ends.
---@param name string
---@param fn function
function Test.case(name, fn) end
---@param condition any
---@param message? string
function Test.expect(condition, message) end
---Compares as == without metamethods does.
---@param actual any
---@param expected any
---@param message? string
function Test.equal(actual, expected, message) end
---@param actual number
---@param expected number
---@param tolerance? number     default 1e-6
---@param message? string
function Test.near(actual, expected, tolerance, message) end
---fn must raise an error that contains the text.
---@param fn function
---@param part? string
---@param message? string
function Test.fails(fn, part, message) end
---Lets so much of the pets' time pass, which takes no real time.
---@async
---@param seconds number
function Test.advance(seconds) end
return hyrax
