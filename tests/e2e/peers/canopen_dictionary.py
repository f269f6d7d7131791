"""The dictionary of a drive of CiA 402, as the library canopen has it."""
import canopen
from canopen.objectdictionary import INTEGER8, INTEGER16, INTEGER32, UNSIGNED8, UNSIGNED16, UNSIGNED32, ODArray, ODRecord, ODVariable

SWITCH_ON_DISABLED = 0x250
OBJECTS = ((0x1000, "Device type", UNSIGNED32, 0x20192), (0x1001, "Error register", UNSIGNED8, 0), (0x1005, "Sync", UNSIGNED32, 0x80),
           (0x1006, "Cycle period", UNSIGNED32, 0), (0x1017, "Producer heartbeat time", UNSIGNED16, 0), (0x603F, "Error code", UNSIGNED16, 0),
           (0x6040, "Controlword", UNSIGNED16, 0), (0x6041, "Statusword", UNSIGNED16, SWITCH_ON_DISABLED), (0x6060, "Modes of operation", INTEGER8, 0),
           (0x6061, "Modes of operation display", INTEGER8, 0), (0x6064, "Position actual value", INTEGER32, 0),
           (0x606C, "Velocity actual value", INTEGER32, 0), (0x6071, "Target torque", INTEGER16, 0), (0x6077, "Torque actual value", INTEGER16, 0),
           (0x607A, "Target position", INTEGER32, 0), (0x60FF, "Target velocity", INTEGER32, 0))


def variable(name, index, sub, kind, value):
    found = ODVariable(name, index, sub)
    found.data_type, found.default, found.value, found.access_type = kind, value, value, "rw"
    return found


def record(dictionary, kind, index, name, *subs):
    made = kind(name, index)
    for sub, (size, value) in enumerate(subs):
        made.add_member(variable(f"{name} {sub}", index, sub, size, value))
    dictionary.add_object(made)


def dictionary_of(node):
    dictionary = canopen.ObjectDictionary()
    dictionary.node_id = node
    for index, name, kind, value in OBJECTS:
        dictionary.add_object(variable(name, index, 0, kind, value))
    record(dictionary, ODArray, 0x1016, "Consumer heartbeat time", (UNSIGNED8, 1), (UNSIGNED32, 0))
    for pdo in range(4):
        for parameters, identifier in ((0x1400, 0x200), (0x1800, 0x180)):
            record(dictionary, ODRecord, parameters + pdo, f"PDO {parameters + pdo:x}", (UNSIGNED8, 2),
                   (UNSIGNED32, 0x80000000 | identifier + 0x100 * pdo + node), (UNSIGNED8, 1))
            record(dictionary, ODArray, parameters + 0x200 + pdo, f"Mapping {parameters + pdo:x}", (UNSIGNED8, 0), *[(UNSIGNED32, 0)] * 8)
    return dictionary
