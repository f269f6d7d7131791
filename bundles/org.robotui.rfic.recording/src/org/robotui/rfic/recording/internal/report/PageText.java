package org.robotui.rfic.recording.internal.report;

import java.util.Locale;

/** A page or a figure that is written from its beginning to its end. What recordings say is text, never markup. */
final class PageText {
  private final StringBuilder all = new StringBuilder();

  /** Adds what is well formed already. */
  PageText markup(String text) {
    all.append(text);
    return this;
  }

  /** Adds markup with numbers in it. */
  PageText format(String form, Object... numbers) {
    all.append(String.format(Locale.ROOT, form, numbers));
    return this;
  }

  /** Adds text. */
  PageText text(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '<' -> all.append("&lt;");
        case '>' -> all.append("&gt;");
        case '&' -> all.append("&amp;");
        case '"' -> all.append("&quot;");
        default -> all.append(c < ' ' && c != '\n' && c != '\t' ? '\ufffd' : c);
      }
    }
    return this;
  }

  /** Adds an element with text in it. */
  PageText element(String name, String text) {
    return markup("<" + name + ">").text(text).markup("</" + name.split(" ", 2)[0] + ">");
  }

  @Override
  public String toString() {
    return all.toString();
  }
}
