package org.robotui.uic.plot.internal.view;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
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
    List<CsvExport.Column> columns = scene.traces().filter(TraceView::drawn)
        .map(t -> new CsvExport.Column(t.spec().signal(), t.unit(), t.series().orElseThrow().samples())).toList();
    say("writing " + file, true);
    background.execute(() -> write(new CsvExport(columns, span), file));
  }

  private void write(CsvExport export, String file) {
    try (Writer out = Files.newBufferedWriter(Path.of(file), StandardCharsets.UTF_8)) {
      long rows = export.write(out);
      say("saved " + rows + " rows to " + file, true);
    } catch (IOException e) {
      say("cannot write " + file + ": " + WriteFailure.reason(e), false);
    } catch (InvalidPathException e) {
      say("cannot write " + file + ": " + e.getMessage(), false);
    }
  }
}
