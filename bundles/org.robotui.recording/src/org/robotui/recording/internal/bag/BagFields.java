package org.robotui.recording.internal.bag;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** The named fields of a record's header, or of a connection. */
final class BagFields {

  static final int MESSAGE = 0x02;
  static final int BAG = 0x03;
  static final int INDEX = 0x04;
  static final int CHUNK = 0x05;
  static final int CHUNK_INFO = 0x06;
  static final int CONNECTION = 0x07;

  /** Headers that are longer are none. Definitions of types lie in data. */
  static final int MOST_HEADER = 1 << 20;

  private final Map<String, byte[]> fields = new HashMap<>();

  /** Fields up to the end of a range. */
  BagFields(PackedFields range) throws MalformedRecord {
    while (range.hasMore()) {
      byte[] field = range.block("a field");
      int name = 0;
      while (name < field.length && field[name] != '=') {
        name++;
      }
      if (name == field.length) {
        throw new MalformedRecord("a field has no '='");
      }
      byte[] value = Arrays.copyOfRange(field, name + 1, field.length);
      fields.put(new String(field, 0, name, StandardCharsets.UTF_8), value);
    }
  }

  int op() throws MalformedRecord {
    return number("op").u8("op");
  }

  int u32(String name) throws MalformedRecord {
    return (int) number(name).u32(name);
  }

  long size(String name) throws MalformedRecord {
    return number(name).size(name);
  }

  long time(String name) throws MalformedRecord {
    return time(number(name), name);
  }

  static long time(PackedFields fields, String what) throws MalformedRecord {
    long seconds = fields.u32(what);
    return seconds * 1_000_000_000L + fields.u32(what);
  }

  Optional<String> text(String name) {
    return Optional.ofNullable(fields.get(name)).map(value -> new String(value, StandardCharsets.UTF_8));
  }

  String needText(String name) throws MalformedRecord {
    return text(name).orElseThrow(() -> new MalformedRecord("there is no field '" + name + "'"));
  }

  byte[] bytes(String name) {
    return fields.getOrDefault(name, new byte[0]);
  }

  private PackedFields number(String name) throws MalformedRecord {
    byte[] value = fields.get(name);
    if (value == null) {
      throw new MalformedRecord("there is no field '" + name + "'");
    }
    return new PackedFields(value, 0, value.length);
  }
}
