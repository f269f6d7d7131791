package org.robotui.uic.joints.internal.model;

import java.util.List;
import java.util.stream.Collectors;

/** Joints as text for other programs: SI units, all digits. */
public final class Export {
  private static final String HEAD = "source,joint,position,velocity,effort,age_s\n";

  private Export() {}

  /** A line per joint; what is unknown is empty. */
  public static String csv(List<JointRow> rows) {
    return rows.stream().map(Export::csvLine).collect(Collectors.joining("", HEAD, ""));
  }

  private static String csvLine(JointRow row) {
    return String.join(",", csvText(row.source().toString()), csvText(row.joint().name()), csv(row.joint().position()),
        csv(row.joint().velocity()), csv(row.joint().effort()), csv(row.ageSeconds())) + "\n";
  }

  private static String csv(double value) {
    return Double.isNaN(value) ? "" : Double.toString(value);
  }

  private static String csvText(String text) {
    return text.matches("[^\",\\r\\n]*") ? text : "\"" + text.replace("\"", "\"\"") + "\"";
  }

  /** A map of joints per source, as {@code .nan} where a value is unknown. */
  public static String yaml(List<JointRow> rows) {
    return rows.stream().map(row -> row.source().toString()).distinct()
        .map(source -> quoted(source) + ":\n" + yaml(rows, source)).collect(Collectors.joining());
  }

  private static String yaml(List<JointRow> rows, String source) {
    return rows.stream().filter(row -> row.source().toString().equals(source)).map(Export::yamlEntry)
        .collect(Collectors.joining());
  }

  private static String yamlEntry(JointRow row) {
    return "  " + quoted(row.joint().name()) + ": {position: " + yaml(row.joint().position())
        + ", velocity: " + yaml(row.joint().velocity()) + ", effort: " + yaml(row.joint().effort()) + "}\n";
  }

  private static String yaml(double value) {
    if (Double.isNaN(value)) {
      return ".nan";
    }
    return Double.isInfinite(value) ? value > 0 ? ".inf" : "-.inf"
        : Double.toString(value).replaceFirst("E(?=\\d)", "E+");
  }

  /** Names of robots are hostile: whatever is in them stays one text. */
  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    text.codePoints().forEach(c -> {
      switch (c) {
        case '"' -> quoted.append("\\\"");
        case '\\' -> quoted.append("\\\\");
        case '\n' -> quoted.append("\\n");
        default -> quoted.append(c < ' ' || c == 0x7f ? String.format("\\x%02x", c) : Character.toString(c));
      }
    });
    return quoted.append('"').toString();
  }
}
