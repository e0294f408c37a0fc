
-- SDOs and emergencies.

local ABORTS = {
    { 0x05030000, "toggle bit not changed" },
    { 0x05040000, "timeout of the SDO protocol" },
    { 0x05040001, "unknown command specifier" },
    { 0x05040005, "out of memory" },
    { 0x06010000, "access to the object is not supported" },
    { 0x06010001, "read of an object that can only be written" },
    { 0x06010002, "write of an object that can only be read" },
    { 0x06010003, "subindex 0 has to be 0 before other subindices are written" },
    { 0x06010004, "complete access is not supported for the object" },
    { 0x06010005, "the object is longer than the mailbox" },
    { 0x06010006, "the object is mapped to an RxPDO, so a download is blocked" },
    { 0x06020000, "the object does not exist" },
    { 0x06040041, "the object cannot be mapped to a PDO" },
    { 0x06040042, "number and length of the objects to be mapped exceed the PDO" },
    { 0x06040043, "parameters do not fit together" },
    { 0x06040047, "internal incompatibility of the device" },
    { 0x06060000, "access failed because of a hardware error" },
    { 0x06070010, "type or length of the data do not match" },
    { 0x06070012, "too much data" },
    { 0x06070013, "too little data" },
    { 0x06090011, "the subindex does not exist" },
    { 0x06090030, "value out of range" },
    { 0x06090031, "value too high" },
    { 0x06090032, "value too low" },
    { 0x06090033, "modules found do not match those configured" },
    { 0x06090036, "the greatest value is less than the least" },
    { 0x08000000, "general error" },
    { 0x08000020, "the data cannot be transferred or stored" },
    { 0x08000021, "the data cannot be transferred or stored because of local control" },
    { 0x08000022, "the data cannot be transferred or stored in the present state" },
    { 0x08000023, "there is no object dictionary" },
}

local function abort_name(code)
    for _, it in ipairs(ABORTS) do
        if it[1] == code then return it[2] end
    end
end

-- A value as text, with what it means.
local function text_of(key, data)
    local entry = ENTRIES[key]
    if not entry or entry[2] == "bytes" then return tostring(data():bytes()), nil end
    local bits = entry[2] == "text" and data:len() * 8 or entry[3]
    if bits > data:len() * 8 then return tostring(data():bytes()), nil end
    local value, number = value_at(entry[2], entry[3], data, 0, bits)
    local text = tostring(value)
    if number then
        text = string.format("%d", number)
        if entry.word then text = string.format("0x%X", number) end
        local name = meaning(entry, number)
        if name then text = text .. " (" .. name .. ")" end
    end
    return text, number
end

-- What of an SDO is data; none where it has none.
local function data_of(sdo)
    local command = sdo(0, 1):uint()
    local size = sdo:len() - 4
    if bits_of(command, 1, 1) == 1 then
        size = bits_of(command, 0, 0) == 1 and 4 - bits_of(command, 2, 3) or 4
        return sdo(4, math.min(size, sdo:len() - 4)):tvb()
    end
    local whole = sdo(4, 4):le_uint()
    size = math.min(whole, sdo:len() - 8)
    return size > 0 and sdo(8, size):tvb() or nil
end

-- Keeps what a transfer tells of process data and identity.
local function learn_data(station, index, subindex, is_complete, data, pinfo)
    if is_complete and is_telling(index) then
        local width = (index == 0x1C12 or index == 0x1C13) and 2 or 4
        learn_object(station, index, 0, pinfo, data(0, 1):uint())
        for at = 2, data:len() - width, width do
            learn_object(station, index, (at - 2) / width + 1, pinfo, data(at, width):le_uint())
        end
    elseif data:len() <= 4 then
        learn_object(station, index, subindex, pinfo, data():le_uint())
    end
end

-- Command specifiers: those of the master, and those of the device.
local REQUESTS = { [0] = "download segment", "download", "upload", "upload segment", "abort" }
local RESPONSES = { [0] = "upload segment", "download segment", "upload", "download", "abort" }

-- What goes with an index: a name, and if there are data, their value.
local function add_object(tree, sdo, is_complete, data)
    local index, subindex = sdo(1, 2):le_uint(), sdo(3, 1):uint()
    local name = name_of(index, subindex)
    if is_complete then name = (OBJECTS[index] or name) .. ", all entries" end
    tree:add_le(fields["sdo.index"], sdo(1, 2))
    tree:add(fields["sdo.subindex"], sdo(3, 1))
    tree:add(fields["sdo.name"], sdo(1, 3), name)
    local said = string.format("0x%04X:%02X %s", index, subindex, name)
    if data and not is_complete then
        local text, number = text_of(index * 256 + subindex, data)
        local item = tree:add(fields["sdo.value"], data(), text)
        local entry = ENTRIES[index * 256 + subindex]
        if entry and entry.filter and entry.word and number then
            add_word(item, entry, data(), number)
        end
        said = said .. " = " .. text
    end
    return said
end

-- An SDO, without the header of CoE.
local function add_sdo(root, station, sdo, is_response, pinfo)
    if sdo:len() < 8 then return end
    local command = sdo(0, 1):uint()
    local specifier = bits_of(command, 5, 7)
    local what = (is_response and RESPONSES or REQUESTS)[specifier] or "unknown"
    local side = what ~= "abort" and (is_response and " response" or " request") or ""
    local tree = root():add(devc, sdo(), string.format("SDO of station 0x%04X: %s%s", station, what, side))
    tree:add(fields["station"], sdo(), station):set_generated()
    tree:add(fields["sdo.what"], sdo(0, 1), what .. side)
    local index, subindex = sdo(1, 2):le_uint(), sdo(3, 1):uint()
    local said
    if what == "abort" then
        local code = sdo(4, 4):le_uint()
        said = add_object(tree, sdo, false)
        local name = abort_name(code) or "of the vendor"
        tree:add_le(fields["sdo.abort"], sdo(4, 4))
        tree:add(fields["sdo.reason"], sdo(4, 4), name)
        said = said .. string.format(": 0x%08X %s", code, name)
    elseif what == "download" or what == "upload" then
        local is_complete = bits_of(command, 4, 4) == 1 and not (is_response and what == "download")
        local data = (what == "upload") == is_response and data_of(sdo) or nil
        said = add_object(tree, sdo, is_complete, data)
        if data and is_response then
            local asked = known(station, "asked", pinfo)
            learn_data(station, index, subindex, asked and asked.is_complete, data, pinfo)
        elseif data then
            learn(station, "written", pinfo, { index * 256 + subindex, is_complete, data:bytes() })
        elseif not is_response then
            learn(station, "asked", pinfo, { is_complete = is_complete })
        else
            local written = known(station, "written", pinfo)
            if written and written[1] == index * 256 + subindex then
                local bytes = ByteArray.tvb(written[3], "written before")
                learn_data(station, index, subindex, written[2], bytes, pinfo)
            end
        end
    end
    tree:append_text(said and ", " .. said or "")
    pinfo.cols.info:append(string.format(" | %s: SDO %s%s%s", NAME, what, side, said and " " .. said or ""))
end

local function add_emergency(root, station, bytes, pinfo)
    if bytes:len() < 8 then return end
    local code = bytes(0, 2):le_uint()
    local name = named(ERRORS, code) or code == 0 and "no error any more" or "not in the description"
    local text = string.format("Emergency of station 0x%04X: 0x%04X %s", station, code, name)
    local tree = root():add(devc, bytes(), text)
    tree:add(fields["station"], bytes(), station):set_generated()
    tree:add_le(fields["emergency.code"], bytes(0, 2))
    tree:add(fields["emergency.name"], bytes(0, 2), name)
    tree:add(fields["emergency.register"], bytes(2, 1))
    tree:add(fields["emergency.data"], bytes(3, 5))
    pinfo.cols.info:append(string.format(" | %s: emergency 0x%04X %s", NAME, code, name))
end

-- What lies in a mailbox.
local function add_mail(root, station, bytes, pinfo)
    if bytes:len() < 8 then return end
    local length = math.min(bytes(0, 2):le_uint(), bytes:len() - 6)
    if bytes(5, 1):uint() % 16 ~= 3 or length <= 2 then return end
    local service = math.floor(bytes(6, 2):le_uint() / 0x1000)
    local content = bytes(8, length - 2):tvb()
    if service == 1 then
        add_emergency(root, station, content, pinfo)
    elseif service == 2 or service == 3 then
        add_sdo(root, station, content, service == 3, pinfo)
    end
end
