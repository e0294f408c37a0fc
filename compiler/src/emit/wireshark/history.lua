
-- What a capture shows up to a frame. Frames are dissected in any order and several times, so it is kept with the
-- number of the frame that shows it.

local history, stations = {}, {}

function devc.init()
    history, stations = {}, {}
end

local function learn(station, key, pinfo, value)
    if pinfo.visited then return end
    local of = history[station]
    if not of then
        of = {}
        history[station] = of
        stations[#stations + 1] = station
        table.sort(stations)
    end
    of[key] = of[key] or {}
    table.insert(of[key], { pinfo.number, value })
end

-- The last of it up to the frame.
local function known(station, key, pinfo)
    local list = history[station] and history[station][key] or {}
    for at = #list, 1, -1 do
        if list[at][1] <= pinfo.number then return list[at][2] end
    end
end

-- Numbers of objects that say what is in process data, and who a device is.
local function is_telling(index)
    return index == 0x1018 or index == 0x1C12 or index == 0x1C13
        or index >= 0x1600 and index < 0x1800 or index >= 0x1A00 and index < 0x1C00
end

local function learn_object(station, index, subindex, pinfo, number)
    if is_telling(index) then
        learn(station, index * 256 + subindex, pinfo, number)
    end
end

-- The values behind subindex 0; none if nothing was seen of them.
local function known_list(station, index, pinfo)
    local count = known(station, index * 256, pinfo)
    if not count then return nil end
    local values = {}
    for subindex = 1, count do
        values[subindex] = known(station, index * 256 + subindex, pinfo)
    end
    return #values == count and values or nil
end

local function is_listed(station)
    for text in devc.prefs.stations:gmatch("[^%s,;]+") do
        if tonumber(text) == station then return true end
    end
    return false
end

-- Whether a station is, or may be, a device of this kind.
local function is_ours(station, pinfo)
    if devc.prefs.stations:find("%S") then return is_listed(station) end
    local vendor = known(station, 0x101801, pinfo) or VENDOR
    local product = known(station, 0x101802, pinfo) or PRODUCT
    return vendor == VENDOR and product == PRODUCT
end

-- The PDOs that an object assigns.
local function assigned(station, object, pinfo)
    local chosen = CONFIGURATIONS[devc.prefs.configuration]
    if chosen then return chosen[object] end
    return known_list(station, object, pinfo) or ASSIGNED[object]
end

-- What is mapped to a PDO, with its name: as the configuration says, as the capture shows, or by default.
local function mapped(station, pdo, pinfo)
    local described = PDOS[pdo]
    local chosen = CONFIGURATIONS[devc.prefs.configuration]
    if chosen then return chosen.pdos[pdo] or described end
    local list = known_list(station, pdo, pinfo)
    if not list then return described end
    local own = { described and described[1] or "" }
    for _, entry in ipairs(list) do
        local key = math.floor(entry / 256)
        own[#own + 1] = ENTRIES[key] and key or 0
        own[#own + 1] = entry % 256
    end
    return own
end
