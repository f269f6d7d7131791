package org.robotui.message;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;

/**
 * The bytes of a class with one method without branches: a constant pool and code, as the virtual machine's
 * specification has them. Nothing else is needed to read a record field by field and to write it.
 */
final class ClassCode {

  static final int DUP = 89;
  static final int POP = 87;
  static final int AALOAD = 50;
  static final int LONG_TO_INT = 136;
  static final int ARETURN = 176;
  static final int RETURN = 177;
  static final int VIRTUAL = 182;
  static final int SPECIAL = 183;
  static final int NEW = 187;
  static final int CAST = 192;
  private static final int ILOAD = 21;
  private static final int ISTORE = 54;
  private static final int VERSION = 65;
  private static final int FINAL_SUPER_SYNTHETIC = 0x1030;
  private static final int PUBLIC = 1;
  private static final int LDC_W = 19;
  private static final int WIDE = 196;
  private static final int MAX_CODE = 65_535;

  private final ByteArrayOutputStream poolBytes = new ByteArrayOutputStream();
  private final DataOutputStream pool = new DataOutputStream(poolBytes);
  private final ByteArrayOutputStream codeBytes = new ByteArrayOutputStream();
  private final DataOutputStream code = new DataOutputStream(codeBytes);
  private final Map<String, Integer> entries = new HashMap<>();
  private final String parent;
  private int count = 1;
  private int locals;

  /** A class of which {@code parent} has a constructor with an array of objects. */
  ClassCode(Class<?> parent, int locals) {
    this.parent = name(parent);
    this.locals = locals;
  }

  static String name(Class<?> type) {
    return type.getName().replace('.', '/');
  }

  /** A place for a value. */
  int local(Class<?> type) {
    int place = locals;
    locals += type == long.class || type == double.class ? 2 : 1;
    return place;
  }

  void load(Class<?> type, int local) {
    at(ILOAD + kind(type), local);
  }

  void store(Class<?> type, int local) {
    at(ISTORE + kind(type), local);
  }

  private void at(int opcode, int local) {
    put(WIDE, 1);
    put(opcode, 1);
    put(local, 2);
  }

  /** Which of the five kinds of values of the virtual machine a type is: int, long, float, double, reference. */
  private static int kind(Class<?> type) {
    if (!type.isPrimitive()) {
      return 4;
    }
    return type == long.class ? 1 : type == float.class ? 2 : type == double.class ? 3 : 0;
  }

  /** Zero, or false. */
  void zero(Class<?> type) {
    put(new int[]{3, 9, 11, 14}[kind(type)], 1);
  }

  void op(int opcode) {
    put(opcode, 1);
  }

  void text(String value) {
    put(LDC_W, 1);
    put(entry("s" + value, 8, utf8(value)), 2);
  }

  void number(int value) {
    put(LDC_W, 1);
    put(integer(value), 2);
  }

  void type(int opcode, Class<?> type) {
    put(opcode, 1);
    put(type(name(type)), 2);
  }

  void field(Class<?> owner, String field, String descriptor) {
    put(180, 1);
    put(member(9, name(owner), field, descriptor), 2);
  }

  void call(int opcode, String owner, String method, String descriptor) {
    put(opcode, 1);
    put(member(10, owner, method, descriptor), 2);
  }

  /** The whole class, in the package of another. */
  byte[] bytes(Class<?> neighbour, String method, String descriptor) {
    int code = codeBytes.size();
    if (code > MAX_CODE || count > MAX_CODE || locals > MAX_CODE) {
      throw new IllegalArgumentException(neighbour.getName() + " has too many fields");
    }
    byte[] body = codeBytes.toByteArray();
    int self = type(name(neighbour) + "Binding");
    int base = type(parent);
    int codeName = utf8("Code");
    int[] names = {utf8("<init>"), utf8("([Ljava/lang/Object;)V"), utf8(method), utf8(descriptor)};
    int init = member(10, parent, "<init>", "([Ljava/lang/Object;)V");
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(all)) {
      out.writeInt(0xCAFEBABE);
      out.writeInt(VERSION);
      out.writeShort(count);
      poolBytes.writeTo(out);
      for (int each : new int[]{FINAL_SUPER_SYNTHETIC, self, base, 0, 0, 2}) {
        out.writeShort(each);
      }
      method(out, names[0], names[1], codeName, 2,
          new byte[]{42, 43, (byte) 183, (byte) (init >> 8), (byte) init, (byte) 177});
      method(out, names[2], names[3], codeName, locals, body);
      out.writeShort(0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return all.toByteArray();
  }

  private static void method(DataOutputStream out, int name, int descriptor, int codeName, int locals, byte[] body)
      throws IOException {
    for (int each : new int[]{PUBLIC, name, descriptor, 1, codeName}) {
      out.writeShort(each);
    }
    out.writeInt(12 + body.length);
    out.writeShort(MAX_STACK);
    out.writeShort(locals);
    out.writeInt(body.length);
    out.write(body);
    out.writeShort(0);
    out.writeShort(0);
  }

  /** The components of a record, each of two words at most, and a few more. */
  private static final int MAX_STACK = 600;

  private int utf8(String value) {
    return entry("u" + value, 1, value);
  }

  private int type(String name) {
    return entry("c" + name, 7, utf8(name));
  }

  private int integer(int value) {
    Integer known = entries.get("i" + value);
    if (known != null) {
      return known;
    }
    put(pool, 3, 1);
    put(pool, value, 4);
    return add("i" + value);
  }

  private int member(int tag, String owner, String name, String descriptor) {
    String key = "m" + tag + owner + "." + name + descriptor;
    Integer known = entries.get(key);
    if (known != null) {
      return known;
    }
    int type = type(owner);
    int pair = entry("n" + name + ":" + descriptor, 12, utf8(name), utf8(descriptor));
    return entry(key, tag, type, pair);
  }

  private int entry(String key, int tag, Object... values) {
    Integer known = entries.get(key);
    if (known != null) {
      return known;
    }
    put(pool, tag, 1);
    for (Object each : values) {
      if (each instanceof String text) {
        try {
          pool.writeUTF(text);
        } catch (IOException e) {
          throw new IllegalArgumentException("a name is too long", e);
        }
      } else {
        put(pool, (Integer) each, 2);
      }
    }
    return add(key);
  }

  private int add(String key) {
    entries.put(key, count);
    return count++;
  }

  private void put(int value, int size) {
    put(code, value, size);
  }

  private static void put(DataOutputStream out, int value, int size) {
    try {
      switch (size) {
        case 1 -> out.writeByte(value);
        case 2 -> out.writeShort(value);
        default -> out.writeInt(value);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
