package org.robotui.headless.internal;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.robotui.api.host.Host;
import org.robotui.headless.internal.Terminal.Size;

/** Text views in a terminal in place, or, where the output is a file or a pipe, as a block every second. */
final class TextOutput {
  private TextOutput() {}

  static Output create(Host host, PrintStream out, Terminal terminal) {
    TextPages pages = new TextPages(host);
    return terminal.isInteractive() ? new Screen(pages, out, terminal) : new Blocks(pages, out);
  }

  /** Draws over what was drawn before, ten times a second. */
  static final class Screen implements Output {
    private static final String HOME = "\u001b[H";
    private static final String CLEAR_TO_END_OF_LINE = "\u001b[K";
    private static final String CLEAR_BELOW = "\u001b[J";
    private static final String HIDE_CURSOR = "\u001b[?25l";
    private static final String SHOW_CURSOR = "\u001b[?25h";
    private static final String CLEAR_ALL = "\u001b[2J";
    private static final int FRAMES_PER_SIZE = 20;

    private final TextPages pages;
    private final PrintStream out;
    private final Terminal terminal;
    private Size size = Size.USUAL;
    private int frame;

    Screen(TextPages pages, PrintStream out, Terminal terminal) {
      this.pages = pages;
      this.out = out;
      this.terminal = terminal;
    }

    @Override
    public long periodMillis() {
      return 100;
    }

    @Override
    public void show() {
      if (frame == 0) {
        steer(HIDE_CURSOR + CLEAR_ALL);
      }
      if (frame++ % FRAMES_PER_SIZE == 0) {
        size = terminal.size();
      }
      steer(frame(pages.lines(size.columns(), size.rows())));
      out.flush();
    }

    private static String frame(List<String> lines) {
      return HOME + String.join(CLEAR_TO_END_OF_LINE + "\r\n", lines) + CLEAR_TO_END_OF_LINE + CLEAR_BELOW;
    }

    private void steer(String text) {
      out.writeBytes(text.getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void end() {
      steer(SHOW_CURSOR + "\r\n");
      out.flush();
    }
  }

  /** Prints a block a second. */
  static final class Blocks implements Output {
    private static final Size PAPER = new Size(100, 200);

    private final TextPages pages;
    private final PrintStream out;

    Blocks(TextPages pages, PrintStream out) {
      this.pages = pages;
      this.out = out;
    }

    @Override
    public long periodMillis() {
      return 1000;
    }

    @Override
    public void show() {
      pages.lines(PAPER.columns(), PAPER.rows()).forEach(out::println);
      out.println();
      out.flush();
    }
  }
}
