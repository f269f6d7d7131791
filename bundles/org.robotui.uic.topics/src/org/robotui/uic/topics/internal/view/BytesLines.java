package org.robotui.uic.topics.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.data.array.Bytes;
import org.robotui.ui.Role;
import org.robotui.ui.control.Column;

/** Bytes as people read them: sixteen in a line, with what they are as letters. Pure. */
final class BytesLines {
  private static final int EACH = 16;
  private static final int FIRST_LETTER = 0x20;
  private static final int LAST_LETTER = 0x7e;

  private BytesLines() {}

  /**
   * A line.
   *
   * @param offset of its first byte
   * @param hex two digits of each
   * @param letters what they are as ASCII; a dot for what is no letter
   */
  record Line(int offset, String hex, String letters) {}

  static List<Line> of(Bytes bytes) {
    List<Line> lines = new ArrayList<>();
    for (int from = 0; from < bytes.size(); from += EACH) {
      StringBuilder hex = new StringBuilder();
      StringBuilder letters = new StringBuilder();
      for (int i = from; i < Math.min(from + EACH, bytes.size()); i++) {
        int value = bytes.unsigned(i);
        hex.append(i == from ? "" : (i - from) % (EACH / 2) == 0 ? "  " : " ")
            .append(String.format(Locale.ROOT, "%02x", value));
        letters.append(value >= FIRST_LETTER && value <= LAST_LETTER ? (char) value : '.');
      }
      lines.add(new Line(from, hex.toString(), letters.toString()));
    }
    return List.copyOf(lines);
  }

  static List<Column<Line>> columns() {
    return List.of(Column.<Line>values("Offset", line -> String.format(Locale.ROOT, "%06x", line.offset())).width(70)
        .weight(0).role(Role.DIM), Column.<Line>values("Bytes", Line::hex).weight(1).from(380),
        Column.<Line>values("Letters", Line::letters).width(140).weight(0));
  }
}
