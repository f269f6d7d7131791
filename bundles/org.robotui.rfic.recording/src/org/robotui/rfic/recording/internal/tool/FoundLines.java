package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.TimeRange;
import org.robotui.condition.TimedCondition;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.find.ConditionScan;
import org.robotui.rfic.recording.internal.find.FoundSpan;
import org.robotui.rfic.recording.internal.find.ScanOutcome;
import org.robotui.rfic.recording.internal.find.SourceWords;
import org.robotui.rfic.recording.internal.session.RecordedHistory;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** Searches recordings for a condition, and prints a line for each time at which it held. */
final class FoundLines {
  private final LogCommand command;
  private final PrintStream out;
  private final PrintStream err;
  private long found;

  FoundLines(LogCommand command, PrintStream out, PrintStream err) {
    this.command = command;
    this.out = out;
    this.err = err;
  }

  /** Whether all of them could be looked at. */
  boolean print(List<RecordingReader> recordings) throws IOException, UsageException {
    PayloadFormats formats = LogTool.formats();
    List<RecordedHistory> histories = recordings.stream()
        .map(each -> RecordedHistory.of(each, formats, LogTool.INSTANCE)).toList();
    if (histories.stream().allMatch(each -> ConditionScan.sources(condition(), each).isEmpty())) {
      throw new UsageException(SourceWords.nothing(histories.stream().map(SearchableHistory.class::cast)));
    }
    boolean whole = true;
    List<ScanOutcome> outcomes = new ArrayList<>();
    for (int i = 0; i < histories.size(); i++) {
      Optional<ScanOutcome> outcome = search(recordings.get(i), histories.get(i));
      outcome.ifPresent(outcomes::add);
      whole &= outcome.map(ScanOutcome::isWhole).orElse(true) && recordings.get(i).damages().isEmpty();
    }
    Optional<String> unknown = ScanOutcome.neverKnown(outcomes);
    if (unknown.isPresent()) {
      throw new UsageException("--where: " + unknown.get());
    }
    if (!command.json()) {
      out.println(found == 1 ? "1 event was found" : found + " events were found");
    }
    return whole;
  }

  /** Conditions remember what they have seen: each recording has its own. */
  private TimedCondition condition() {
    return TimedCondition.parse(command.where(), 0);
  }

  private Optional<ScanOutcome> search(RecordingReader recording, SearchableHistory history)
      throws IOException, UsageException {
    Optional<TimeRange> range = LogTool.range(command, recording, history.span());
    if (range.isEmpty()) {
      return Optional.empty();
    }
    try {
      ScanOutcome outcome = ConditionScan.run(condition(), history, range.get(),
          span -> print(recording, history.span().start(), span), time -> true);
      outcome.problems().forEach(each -> err.println("robotui: " + recording.file() + ": " + each));
      recording.damages().forEach(each -> err.println("robotui: " + recording.file() + ": " + each));
      return Optional.of(outcome);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private void print(RecordingReader recording, long start, FoundSpan span) {
    found++;
    out.println(command.json() ? json(recording, span) : text(recording, start, span));
  }

  private static String json(RecordingReader recording, FoundSpan span) {
    return new JsonLine().open('{').name("file").text(recording.file().toString())
        .name("start").text(Long.toString(span.range().start())).name("end").text(Long.toString(span.range().end()))
        .name("over").word(Boolean.toString(span.over())).name("what").text(span.words()).close('}').toString();
  }

  private String text(RecordingReader recording, long start, FoundSpan span) {
    String file = command.from().size() == 1 ? "" : recording.file() + "  ";
    String begin = LogTime.seconds(span.range().start() - start) + " s";
    String length = span.range().length() == 0 && span.over() ? ""
        : ", for " + LogTime.seconds(span.range().length()) + " s" + (span.over() ? "" : " until the end");
    return file + LogTime.instant(span.range().start()) + "  " + begin + length + ": " + span.words();
  }
}
