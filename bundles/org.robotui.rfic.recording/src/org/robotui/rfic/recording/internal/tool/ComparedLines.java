package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.util.Locale;
import org.robotui.api.replay.TimeRange;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.compare.CompareException;
import org.robotui.rfic.recording.internal.compare.CompareWish;
import org.robotui.rfic.recording.internal.compare.ComparedFile;
import org.robotui.rfic.recording.internal.compare.ComparedRuns;
import org.robotui.rfic.recording.internal.compare.ErrorFigures;
import org.robotui.rfic.recording.internal.compare.ErrorSeries;
import org.robotui.rfic.recording.internal.compare.RunComparison;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.rfic.recording.internal.session.RecordedHistory;

/** Compares two recordings, and prints what it comes to. */
final class ComparedLines {
  private static final String INSTANCE = "recording";
  private static final double SECONDS = 1e-9;

  private final CompareCommand command;
  private final PrintStream out;
  private final PrintStream err;
  private final PayloadFormats formats = LogTool.formats();

  ComparedLines(CompareCommand command, PrintStream out, PrintStream err) {
    this.command = command;
    this.out = out;
    this.err = err;
  }

  /** Whether all that was compared could be read. */
  boolean print() throws IOException, UsageException {
    if (command.csv().filter(Files::exists).isPresent()) {
      throw new UsageException(command.csv().get() + " is there already: name a file that is new");
    }
    try (RecordingReader one = RecordingFiles.open(command.first(), command.types(), ScanProgress.NONE);
        RecordingReader other = RecordingFiles.open(command.second(), command.types(), ScanProgress.NONE)) {
      ComparedFile first = file(one);
      ComparedFile second = file(other);
      boolean whole = true;
      for (CompareWish wish : command.wishes()) {
        whole &= print(wish, new RunComparison(first, second, wish).run());
      }
      return whole;
    } catch (CompareException e) {
      throw new UsageException(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("it was interrupted", e);
    }
  }

  private ComparedFile file(RecordingReader recording) throws UsageException {
    RecordingInterval span = recording.span().orElse(new RecordingInterval(0, 0));
    long begin = command.begin().map(time -> time.in(span)).orElse(span.start());
    long end = command.end().map(time -> time.in(span)).orElse(span.end());
    if (end < begin) {
      throw new UsageException("--to lies before --from");
    }
    return new ComparedFile(recording.file().getFileName().toString(),
        RecordedHistory.of(recording, formats, INSTANCE), new TimeRange(begin, end), 0);
  }

  private boolean print(CompareWish wish, ComparedRuns compared) throws IOException {
    out.print(command.json() ? json(wish, compared) : text(wish, compared));
    compared.problems().forEach(each -> err.println("robotui: " + each));
    if (command.csv().isPresent()) {
      Files.writeString(command.csv().get(), compared.report(0).csv());
    }
    return compared.problems().isEmpty();
  }

  private static String text(CompareWish wish, ComparedRuns compared) {
    StringBuilder text = new StringBuilder();
    text.append(wish.topic()).append(": ").append(compared.pairs()).append(" pairs of ").append(compared.first())
        .append(" and ").append(compared.second()).append(" values");
    if (compared.shift() != 0) {
      text.append(String.format(Locale.ROOT, ", %.3f s added to times of the second", compared.shift() * SECONDS));
    }
    text.append(String.format(Locale.ROOT, "%n%-28s %6s %12s %12s %12s %12s %12s %12s%n", "", "count", "rmse", "mean",
        "median", "std", "min", "max"));
    for (ErrorSeries each : compared.errors()) {
      ErrorFigures f = each.figures();
      text.append(String.format(Locale.ROOT, "%-28s %6d %12.6f %12.6f %12.6f %12.6f %12.6f %12.6f%n", title(each),
          f.count(), f.rmse(), f.mean(), f.median(), f.deviation(), f.least(), f.most()));
    }
    return text.toString();
  }

  private static String title(ErrorSeries errors) {
    return errors.unit().isEmpty() ? errors.name() : errors.name() + " [" + errors.unit() + "]";
  }

  private static String json(CompareWish wish, ComparedRuns compared) {
    JsonLine line = new JsonLine();
    line.open('{').name("topic").text(wish.topic().toString()).name("pairs").word(Integer.toString(compared.pairs()))
        .name("shift").text(Long.toString(compared.shift())).name("errors").open('[');
    for (ErrorSeries each : compared.errors()) {
      ErrorFigures f = each.figures();
      line.open('{').name("name").text(each.name()).name("unit").text(each.unit()).name("count")
          .word(Integer.toString(f.count())).name("rmse").word(Double.toString(f.rmse())).name("mean")
          .word(Double.toString(f.mean())).name("median").word(Double.toString(f.median())).name("std")
          .word(Double.toString(f.deviation())).name("min").word(Double.toString(f.least())).name("max")
          .word(Double.toString(f.most())).close('}');
    }
    return line.close(']').close('}') + "\n";
  }
}
