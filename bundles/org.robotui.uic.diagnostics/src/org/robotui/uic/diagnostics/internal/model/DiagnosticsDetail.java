package org.robotui.uic.diagnostics.internal.model;

import java.util.List;

/**
 * Everything about one line of the tree, at the moment looked at.
 *
 * @param key what identifies it
 * @param title the name as the robot gives it
 * @param source where it comes from
 * @param level how it is
 * @param hardware the device, may be empty
 * @param message what it says
 * @param told when it said so, in words
 * @param values names and values, in the order given; of a group, what is below it
 * @param strip how it was
 */
public record DiagnosticsDetail(String key, String title, String source, Level level, String hardware, String message,
    String told,
    List<Value> values, Strip strip) {
  /**
   * A detail.
   *
   * @param name its name
   * @param value its value
   */
  public record Value(String name, String value) {}

  /** As text, for the clipboard. */
  public String text() {
    StringBuilder text =
        new StringBuilder(title).append("  ").append(level.word()).append("  ").append(message).append('\n');
    if (!hardware.isEmpty()) {
      text.append("hardware: ").append(hardware).append('\n');
    }
    values.forEach(v -> text.append(v.name()).append(": ").append(v.value()).append('\n'));
    return text.toString();
  }
}
