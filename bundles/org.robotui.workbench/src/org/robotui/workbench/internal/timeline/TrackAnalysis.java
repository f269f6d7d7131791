package org.robotui.workbench.internal.timeline;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.api.replay.OffsetEstimation;
import org.robotui.api.replay.RecordingReports;
import org.robotui.api.replay.RecordingVideos;
import org.robotui.api.replay.TrackId;
import org.robotui.workbench.internal.timeline.RecordingCalls.Answer;

/** What takes long and is asked of one recording, one thing at a time; all windows share it. Display thread. */
public final class TrackAnalysis {
  private static final String NOT_THERE = "the feature 'RobotUI recordings' is not installed";

  private final RecordingCalls calls;
  private final Supplier<Optional<OffsetEstimation>> offsets;
  private final Supplier<Optional<RecordingReports>> reports;
  private final Supplier<Optional<RecordingVideos>> videos;
  private final Map<TrackId, String> busy = new HashMap<>();

  /**
   * With nothing to do yet.
   *
   * @param calls runs what is asked for
   * @param offsets estimates offsets, where it is there
   * @param reports writes reports, where it is there
   * @param videos writes videos, where it is there
   */
  public TrackAnalysis(RecordingCalls calls, Supplier<Optional<OffsetEstimation>> offsets,
      Supplier<Optional<RecordingReports>> reports, Supplier<Optional<RecordingVideos>> videos) {
    this.calls = calls;
    this.offsets = offsets;
    this.reports = reports;
    this.videos = videos;
  }

  boolean isBusy(TrackId track) {
    return busy.containsKey(track);
  }

  /** What is being done with a recording, in a few words; none where nothing is. */
  Optional<String> doing(TrackId track) {
    return Optional.ofNullable(busy.get(track));
  }

  /** Estimates by how much a recording is to be moved. */
  void offset(TrackId reference, TrackId moved, Consumer<Answer<OffsetEstimate>> told) {
    start(moved, "estimating its offset", () -> there(offsets).estimate(reference, moved)
        .orElseThrow(() -> new IllegalArgumentException(OffsetEstimate.NONE)), told);
  }

  /** Writes a report to a file. */
  void report(TrackId track, Path file, Consumer<Answer<Path>> told) {
    start(track, "writing a report", () -> RecordingCalls.write(file, there(reports).page(track)), told);
  }

  /** Writes a video of a camera to a file that the user chose, in place of what is there. */
  void video(TrackId track, String topic, Path file, Consumer<Answer<Path>> told) {
    start(track, "writing a video", () -> {
      Files.deleteIfExists(file);
      there(videos).write(track, topic, file);
      return file;
    }, told);
  }

  private static <S> S there(Supplier<Optional<S>> service) {
    return service.get().orElseThrow(() -> new IllegalArgumentException(NOT_THERE));
  }

  private <V> void start(TrackId track, String words, RecordingCalls.Call<V> call, Consumer<Answer<V>> told) {
    if (busy.putIfAbsent(track, words) == null) {
      calls.start(call, answer -> {
        busy.remove(track);
        told.accept(answer);
      });
    }
  }
}
