package org.robotui.headless.internal;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import org.robotui.api.config.Printable;

/**
 * What is printed for a terminal. Much of it came from a file or a network, and must not steer the terminal: all but
 * the ends of lines is shown, not obeyed. What we steer it with ourselves goes through {@link #writeBytes}.
 */
final class TerminalOut extends PrintStream {
  TerminalOut(OutputStream out, Charset charset) {
    super(out, false, charset);
  }

  @Override
  public void print(String text) {
    if (text == null || Printable.isPlain(text)) {
      super.print(text);
      return;
    }
    String[] lines = text.split("\n", -1);
    for (int i = 0; i < lines.length; i++) {
      super.print(Printable.of(lines[i]) + (i < lines.length - 1 ? "\n" : ""));
    }
  }
}
