package org.robotui.script.internal.engine;

import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.mozilla.javascript.ScriptRuntime;
import org.robotui.api.config.Printable;
import org.robotui.api.script.ScriptCallback;

/** Plain values as users read them, nearly as they would write them. What is long is cut, and says so. */
public final class PlainText {
  private static final int LONGEST = 20_000;

  private final StringBuilder text = new StringBuilder();

  private PlainText() {}

  /** A value with texts in quotes. */
  public static String of(Object value) {
    PlainText made = new PlainText();
    made.value(value);
    return made.text.length() > LONGEST
        ? made.text.substring(0, LONGEST) + "\u2026 (cut after " + LONGEST + " characters)"
        : made.text.toString();
  }

  /** A limit, in seconds where it has whole ones. */
  public static String of(Duration time) {
    return time.toMillis() % 1000 == 0 ? time.toSeconds() + " s" : time.toMillis() + " ms";
  }

  private void value(Object value) {
    if (text.length() > LONGEST) {
      return;
    }
    switch (value) {
      case null -> text.append("null");
      case Number number -> text.append(ScriptRuntime.toString(number.doubleValue()));
      case Boolean flag -> text.append(flag);
      case List<?> items -> list(items);
      case Map<?, ?> members -> map(members);
      case ScriptCallback function -> text.append("function");
      default -> quoted(value.toString());
    }
  }

  private void list(List<?> items) {
    text.append('[');
    for (Iterator<?> all = items.iterator(); all.hasNext() && text.length() <= LONGEST;) {
      value(all.next());
      text.append(all.hasNext() ? ", " : "");
    }
    text.append(']');
  }

  private void map(Map<?, ?> members) {
    text.append('{');
    for (Iterator<? extends Map.Entry<?, ?>> all = members.entrySet().iterator(); all.hasNext()
        && text.length() <= LONGEST;) {
      Map.Entry<?, ?> member = all.next();
      String name = member.getKey().toString();
      if (name.matches("[A-Za-z_$][A-Za-z0-9_$]*")) {
        text.append(name);
      } else {
        quoted(name);
      }
      text.append(": ");
      value(member.getValue());
      text.append(all.hasNext() ? ", " : "");
    }
    text.append('}');
  }

  /** As a script would write it; letters of all languages stay as they are. */
  private void quoted(String words) {
    String cut = words.length() > LONGEST ? words.substring(0, LONGEST + 1) : words;
    String escaped = cut.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n").replace("\t", "\\t");
    text.append('"').append(Printable.of(escaped)).append('"');
  }
}
