package org.robotui.player.log;

import java.util.ArrayList;
import java.util.List;

/**
 * How one kind of message stands in a log file.
 *
 * @param parts the parts in their order
 * @param space whether a space ends the line
 */
record LineLayout(List<LinePart> parts, boolean space) {

  static LineLayout parse(String text) {
    List<LinePart> parts = new ArrayList<>();
    List<LinePart.Element> each = new ArrayList<>();
    boolean space = false;
    for (String word : text.strip().split(" +")) {
      switch (word) {
        case "(" -> each = new ArrayList<>();
        case ")" -> parts.add(new LinePart.Each(List.copyOf(each)));
        case "~" -> space = true;
        default -> add(word, parts, each);
      }
    }
    return new LineLayout(List.copyOf(parts), space);
  }

  private static void add(String word, List<LinePart> parts, List<LinePart.Element> each) {
    int percent = word.indexOf('%');
    String path = word.substring(0, percent);
    String format = word.substring(percent);
    int brackets = path.indexOf("[]");
    if (format.equals("%hex")) {
      parts.add(new LinePart.Hex(path));
    } else if (path.endsWith("#")) {
      parts.add(new LinePart.Length(path.substring(0, path.length() - 1), NumberFormat.of(format)));
    } else if (brackets >= 0) {
      String rest = path.substring(brackets + 2);
      each.add(new LinePart.Element(path.substring(0, brackets), rest.startsWith(".") ? rest.substring(1) : rest,
          NumberFormat.of(format)));
    } else {
      parts.add(new LinePart.Scalar(path, NumberFormat.of(format)));
    }
  }
}
