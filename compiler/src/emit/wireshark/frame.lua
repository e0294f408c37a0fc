
-- Frames: datagrams one behind the other, and the registers in them. The fields of Wireshark's own dissector have other
-- names in each datagram, so the frame is read here once more.

local AL_STATES = { [1] = "Init", [2] = "Pre-Operational", [3] = "Bootstrap", [4] = "Safe-Operational", [8] = "Operational" }

local ethertypes = { Field.new("eth.type"), Field.new("vlan.etype") }

-- Where EtherCAT begins in a frame of Ethernet.
local function beginning(frame)
    if not ethertypes[1]() or frame:len() < 18 then return nil end
    local at = 12
    while frame(at, 2):uint() == 0x8100 and frame:len() >= at + 8 do at = at + 4 end
    return frame(at, 2):uint() == 0x88A4 and at + 2 or nil
end

-- A register that a datagram covers.
local function register(data, offset, at, size)
    if at < offset or at + size > offset + data:len() then return nil end
    return data(at - offset, size)
end

-- What a master sets up: where mail and process data lie.
local function learn_registers(station, offset, data, pinfo)
    for manager = 0, 3 do
        local start = register(data, offset, 0x800 + 8 * manager, 2)
        if start then learn(station, "manager " .. manager, pinfo, start:le_uint()) end
    end
    for unit = 0, 15 do
        local it = register(data, offset, 0x600 + 16 * unit, 13)
        if it then
            learn(station, "unit " .. unit, pinfo, {
                logical = it(0, 4):le_uint(), length = it(4, 2):le_uint(), physical = it(8, 2):le_uint(),
                kind = it(11, 1):uint(), active = it(12, 1):uint() % 2 == 1,
            })
        end
    end
    local word = register(data, offset, 0x504, 4)
    if word then learn(station, "word of the EEPROM", pinfo, word:le_uint()) end
end

-- What a device says of itself in its EEPROM: vendor at word 8, product at word 10.
local function learn_identity(station, offset, data, pinfo)
    local word = known(station, "word of the EEPROM", pinfo)
    for part = 0, 1 do
        local number = register(data, offset, 0x508 + 4 * part, 4)
        local at = word and word + 2 * part
        if number and at == 8 then learn(station, 0x101801, pinfo, number:le_uint()) end
        if number and at == 10 then learn(station, 0x101802, pinfo, number:le_uint()) end
    end
end

local function add_state(root, station, offset, data, pinfo)
    local control, status = register(data, offset, 0x120, 1), register(data, offset, 0x130, 1)
    local at = control or status
    if not at then return end
    local number = at:uint()
    local name = AL_STATES[number % 16] or "unknown"
    if status and bits_of(number, 4, 4) == 1 then name = name .. ", error" end
    local what = control and "State requested" or "State"
    local tree = root():add(devc, at, string.format("%s of station 0x%04X: %s", what, station, name))
    tree:add(fields["station"], at, station):set_generated()
    tree:add(fields[control and "al.requested" or "al.state"], at, name)
    local code = register(data, offset, 0x134, 2)
    if status and code then
        local number = code:le_uint()
        local name = named(AL_CODES, number) or "not in the description"
        tree:add_le(fields["al.code"], code)
        tree:add(fields["al.reason"], code, name)
        if number ~= 0 then
            tree:append_text(string.format(", 0x%04X %s", number, name))
            pinfo.cols.info:append(string.format(" | %s: AL status 0x%04X %s", NAME, number, name))
        end
    end
end

-- A datagram to a station; `back` if it has been there.
local function add_physical(root, command, station, offset, data, back, pinfo)
    local writes, reads = command == 5 or command == 6, command == 4 or command == 6
    if writes then learn_registers(station, offset, data, pinfo) end
    if reads and back then learn_identity(station, offset, data, pinfo) end
    if not is_ours(station, pinfo) then return end
    local function begins(manager)
        return manager and (known(station, "manager " .. manager, pinfo) or MANAGERS[manager])
    end
    if writes and not back then
        if register(data, offset, 0x120, 1) then add_state(root, station, offset, data, pinfo) end
        if offset == begins(MAILBOX_OUT) then add_mail(root, station, data, pinfo) end
    elseif reads and back then
        if register(data, offset, 0x130, 1) then add_state(root, station, offset, data, pinfo) end
        if offset == begins(MAILBOX_IN) then add_mail(root, station, data, pinfo) end
    end
end

-- The units of a station: as the capture shows, or as someone says who looks at it.
local function units_of(station, pinfo)
    local units = {}
    for unit = 0, 15 do
        local it = known(station, "unit " .. unit, pinfo)
        -- one that carries the state of a mailbox has no process data
        if it and it.active and (it.physical < 0x800 or it.physical >= 0x1000) then units[#units + 1] = it end
    end
    return units
end

local function add_unit(root, station, it, way, address, data, pinfo)
    local at = it.logical - address
    if it.kind == way and it.length > 0 and at >= 0 and at + it.length <= data:len() then
        local object = way == 2 and 0x1C12 or 0x1C13
        add_image(root, station, object, data(at, it.length):tvb(), pinfo)
    end
end

-- A datagram to logical memory: outputs on the way there, inputs on the way back.
local function add_logical(root, command, address, data, back, pinfo)
    local way = back and 1 or 2
    if way == 1 and command == 11 or way == 2 and command == 10 then return end
    local told = tonumber(way == 2 and devc.prefs.outputs or devc.prefs.inputs)
    if told then
        local station = tonumber(devc.prefs.stations:match("[^%s,;]+") or "0")
        local object = way == 2 and 0x1C12 or 0x1C13
        local length = size_of(layout_of(station, object, pinfo))
        add_unit(root, station, { logical = told, length = length, kind = way }, way, address, data, pinfo)
        return
    end
    for _, station in ipairs(stations) do
        if is_ours(station, pinfo) then
            for _, it in ipairs(units_of(station, pinfo)) do
                add_unit(root, station, it, way, address, data, pinfo)
            end
        end
    end
end

function devc.dissector(frame, pinfo, tree)
    local at = beginning(frame)
    if not at or math.floor(frame(at, 2):le_uint() / 0x1000) ~= 1 then return end
    local item
    local function root()
        item = item or tree:add(devc, frame(at), NAME .. ", as described")
        return item
    end
    local datagram, more = at + 2, true
    while more and datagram + 12 <= frame:len() do
        local command = frame(datagram, 1):uint()
        local length = frame(datagram + 6, 2):le_uint()
        length, more = length % 0x800, length >= 0x8000
        local finish = datagram + 10 + length
        if finish + 2 > frame:len() then return end
        if length > 0 then
            local data, back = frame(datagram + 10, length):tvb(), frame(finish, 2):le_uint() > 0
            if command >= 4 and command <= 6 then
                local station, offset = frame(datagram + 2, 2):le_uint(), frame(datagram + 4, 2):le_uint()
                add_physical(root, command, station, offset, data, back, pinfo)
            elseif command >= 10 and command <= 12 then
                add_logical(root, command, frame(datagram + 2, 4):le_uint(), data, back, pinfo)
            end
        end
        datagram = finish + 2
    end
end

register_postdissector(devc)
