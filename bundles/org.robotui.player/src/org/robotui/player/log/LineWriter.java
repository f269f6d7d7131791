package org.robotui.player.log;

import java.util.HexFormat;
import java.util.List;
import java.util.StringJoiner;
import org.robotui.player.layout.FieldValue;
import org.robotui.player.layout.PlayerRecord;

/** Writes a record as the rest of a line. */
final class LineWriter {

  private final PlayerRecord record;
  private final StringJoiner out = new StringJoiner(" ");
  private int length;

  private LineWriter(PlayerRecord record) {
    this.record = record;
  }

  static String write(LineLayout layout, PlayerRecord record) {
    LineWriter writer = new LineWriter(record);
    layout.parts().forEach(writer::part);
    return writer.out + (layout.space() ? " " : "");
  }

  private void part(LinePart part) {
    switch (part) {
      case LinePart.Scalar scalar -> out.add(scalar.format().write(record.number(scalar.path()).orElse(0)));
      case LinePart.Length count -> {
        length = length(array(count.array()));
        out.add(count.format().write(length));
      }
      case LinePart.Each each -> each(each.parts());
      case LinePart.Hex hex -> out.add(hex(array(hex.path())));
      case LinePart.Element element -> throw new IllegalStateException(element + " stands outside of brackets");
    }
  }

  private static String hex(FieldValue value) {
    return value instanceof FieldValue.Bytes bytes ? HexFormat.of().withUpperCase().formatHex(bytes.value()) : "";
  }

  private void each(List<LinePart.Element> parts) {
    List<FieldValue> arrays = parts.stream().map(part -> array(part.array())).toList();
    for (int i = 0; i < length; i++) {
      for (int part = 0; part < parts.size(); part++) {
        out.add(parts.get(part).format().write(element(arrays.get(part), i, parts.get(part).path())));
      }
    }
  }

  private FieldValue array(String path) {
    return record.at(path).orElseThrow(() -> new IllegalStateException(record + " has no array " + path));
  }

  private static int length(FieldValue array) {
    return switch (array) {
      case FieldValue.Numbers numbers -> numbers.values().length;
      case FieldValue.Bytes bytes -> bytes.value().length;
      case FieldValue.Many many -> many.values().size();
      default -> 0;
    };
  }

  /** Arrays beside the one that counts may be shorter, as intensities are: zeros stand for what is missing. */
  private static double element(FieldValue array, int index, String path) {
    return switch (array) {
      case FieldValue.Numbers numbers when index < numbers.values().length -> numbers.values()[index];
      case FieldValue.Bytes bytes when index < bytes.value().length -> bytes.value()[index] & 0xff;
      case FieldValue.Many many when index < many.values().size() -> many.values().get(index).number(path).orElse(0);
      default -> 0;
    };
  }
}
