package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.api.replay.OffsetEstimation;
import org.robotui.api.replay.TrackId;
import org.robotui.workbench.internal.timeline.RecordingCalls.Answer;

class TrackAnalysisTest {
  private static final TrackId ONE = new TrackId("one", "base");
  private static final TrackId OTHER = new TrackId("other", "base");
  private static final OffsetEstimate FOUND = new OffsetEstimate(5, 1, "messages");

  private final Deque<Runnable> work = new ArrayDeque<>();
  private final RecordingCalls calls = new RecordingCalls(Runnable::run, work::add);
  private final List<Answer<?>> answers = new ArrayList<>();

  private TrackAnalysis analysis(OffsetEstimation estimation) {
    return new TrackAnalysis(calls, () -> Optional.of(estimation), () -> Optional.of(track -> "<html/>"),
        Optional::empty);
  }

  @Test
  void ofOneRecordingOneThingIsDoneAtATime() {
    TrackAnalysis analysis = analysis((reference, moved) -> Optional.of(FOUND));
    analysis.offset(ONE, OTHER, answers::add);
    analysis.offset(ONE, OTHER, answers::add);
    assertTrue(analysis.isBusy(OTHER) && !analysis.isBusy(ONE));
    assertEquals(Optional.of("estimating its offset"), analysis.doing(OTHER));
    assertEquals(1, work.size());
    work.poll().run();
    assertFalse(analysis.isBusy(OTHER));
    assertEquals(Optional.empty(), analysis.doing(OTHER));
    assertEquals(List.of(new Answer.Given<>(FOUND)), answers);
  }

  @Test
  void whyThereIsNoneIsSaid() {
    analysis((reference, moved) -> Optional.empty()).offset(ONE, OTHER, answers::add);
    analysis((reference, moved) -> {
      throw new IOException("run.bag was closed");
    }).offset(ONE, OTHER, answers::add);
    analysis((reference, moved) -> {
      throw new IllegalStateException("odd");
    }).offset(ONE, OTHER, answers::add);
    new TrackAnalysis(calls, Optional::empty, Optional::empty, Optional::empty).offset(ONE, OTHER, answers::add);
    work.forEach(Runnable::run);
    assertEquals(List.of(new Answer.Failed<>(OffsetEstimate.NONE), new Answer.Failed<>("run.bag was closed"),
        new Answer.Failed<>("it failed: java.lang.IllegalStateException: odd"),
        new Answer.Failed<>("the feature 'RobotUI recordings' is not installed")), answers);
  }

  @Test
  void aReportIsWrittenOrItIsSaidWhyNot(@TempDir Path folder) throws IOException {
    TrackAnalysis analysis = analysis((reference, moved) -> Optional.empty());
    Path file = folder.resolve("run.html");
    analysis.report(ONE, file, answers::add);
    analysis.report(OTHER, folder.resolve("none/run.html"), answers::add);
    work.forEach(Runnable::run);
    assertEquals("<html/>", Files.readString(file));
    assertEquals(new Answer.Given<>(file), answers.getFirst());
    assertTrue(answers.getLast().toString().contains("could not be written"), () -> answers.getLast().toString());
  }
}
