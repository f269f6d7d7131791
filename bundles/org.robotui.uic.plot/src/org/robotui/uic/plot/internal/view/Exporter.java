package org.robotui.uic.plot.internal.view;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.uic.plot.internal.model.CsvExport;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** Writes traces to a file in the background, and says for a while what became of it. Safe for all threads. */
public final class Exporter {
  /** What became of the newest file. */
  public record Notice(String text, boolean good, long sinceNanos) {}

  private static final long SHOWN_NANOS = 6_000_000_000L;

  private final Executor background;
  private volatile Optional<Notice> notice = Optional.empty();

  public Exporter(Executor background) {
    this.background = background;
  }

  /** Runs what takes long, beside writing. */
  Executor background() {
    return background;
  }

  /** What to say now, if anything. */
  public Optional<Notice> notice(long nowNanos) {
    return notice.filter(n -> nowNanos - n.sinceNanos() < SHOWN_NANOS);
  }

  /** Says something for a while. */
  public void say(String text, boolean good) {
    notice = Optional.of(new Notice(text, good, System.nanoTime()));
  }

  /** Has all traces that are drawn written. */
  public void export(PlotScene scene, TimeSpan span, String file) {
    List<CsvExport.Column> columns = scene.traces().filter(TraceView::drawn).flatMap(CsvExport.Column::of).toList();
    say("writing " + file, true);
    background.execute(() -> write(file, path -> rows(path, new CsvExport(columns, span)::write)));
  }

  /** Has a text written. */
  public void write(String text, String file) {
    background.execute(() -> write(file, path -> rows(path, out -> {
      out.write(text);
      return text.lines().count() - 1;
    })));
  }

  /** Has a picture written. */
  void picture(PictureFile picture, String file) {
    background.execute(() -> write(file, path -> {
      picture.write(path);
      return "the picture";
    }));
  }

  /** Writes a picture to a file. */
  interface PictureFile {
    void write(Path file) throws IOException;
  }

  /** Writes lines, and says how many. */
  private interface Lines {
    long write(Writer out) throws IOException;
  }

  /** Writes a file, and says what was written. */
  private interface Writing {
    String write(Path file) throws IOException;
  }

  private static String rows(Path file, Lines lines) throws IOException {
    AtomicLong rows = new AtomicLong();
    AtomicFile.write(file, out -> {
      Writer writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
      rows.set(lines.write(writer));
      writer.flush();
    });
    return rows + " rows";
  }

  private void write(String file, Writing writing) {
    try {
      say("saved " + writing.write(Path.of(file)) + " to " + file, true);
    } catch (IOException e) {
      say("cannot write " + file + ": " + WriteFailure.reason(e), false);
    } catch (InvalidPathException e) {
      say("cannot write " + file + ": " + e.getMessage(), false);
    }
  }
}
