package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads any place of the layout by its path: slow and general, where the readers are quick and particular. */
final class Plain {
  private static final Pattern STEP = Pattern.compile("([a-z_]+)(?:\\[(\\d+)])?\\.?");

  private record Place(String type, int offset, int size) {}

  private final Layout layout;
  private final String struct;

  Plain(Layout layout, String struct) {
    this.layout = layout;
    this.struct = struct;
  }

  int size() {
    return layout.size(struct);
  }

  /** What stands there, written like the wanted text where it is a number equal to it. */
  String text(ByteBuffer bytes, String path, String wanted) {
    Place place = place(path);
    int at = place.offset();
    return switch (place.type()) {
      case "Name", "Text" -> Memory.text(bytes, at, place.size());
      case "f64" -> real(bytes.getDouble(at), Double.parseDouble(wanted), wanted);
      case "f32" -> real(bytes.getFloat(at), Float.parseFloat(wanted), wanted);
      case "u64" -> Long.toUnsignedString(bytes.getLong(at));
      case "i64" -> Long.toString(bytes.getLong(at));
      case "u32" -> Integer.toUnsignedString(bytes.getInt(at));
      case "i32" -> Integer.toString(bytes.getInt(at));
      case "u16" -> Integer.toString(Short.toUnsignedInt(bytes.getShort(at)));
      case "u8" -> Integer.toString(Byte.toUnsignedInt(bytes.get(at)));
      default -> throw new AssertionError(path + " is a " + place.type());
    };
  }

  private static String real(double value, double wanted, String text) {
    return Double.compare(value, wanted) == 0 ? text : Double.toString(value);
  }

  private Place place(String path) {
    Place place = new Place(struct, 0, size());
    Matcher step = STEP.matcher(path);
    while (step.find()) {
      Layout.Field field = layout.struct(place.type()).fields().get(step.group(1));
      int index = step.group(2) == null ? 0 : Integer.parseInt(step.group(2));
      place = new Place(field.type(), place.offset() + field.offset() + index * field.size(), field.size());
    }
    return place;
  }
}
