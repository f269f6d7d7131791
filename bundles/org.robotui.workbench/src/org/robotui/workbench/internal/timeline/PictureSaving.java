package org.robotui.workbench.internal.timeline;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.replay.RecordingVideos;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.ui.Theme;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.SaveDialog;
import org.robotui.workbench.internal.pane.ProgressDialog;
import org.robotui.workbench.internal.timeline.RecordingCalls.Answer;

/** Saves what a view shows of the recordings, as a video or as numbered pictures; one at a time. Display thread. */
public final class PictureSaving {
  private static final String TITLE = "Save Pictures of the Recording";
  private static final String RATE = "25";
  private static final double SLOWEST = 0.001;
  private static final double FASTEST = 1000;

  private final RecordingCalls calls;
  private final LiveTimeline live;
  private final Supplier<Optional<RecordingVideos>> videos;
  private boolean busy;

  /**
   * Saves nothing yet.
   *
   * @param calls runs what takes long
   * @param live the timeline
   * @param videos writes videos, where it is there
   */
  public PictureSaving(RecordingCalls calls, LiveTimeline live, Supplier<Optional<RecordingVideos>> videos) {
    this.calls = calls;
    this.live = live;
    this.videos = videos;
  }

  /**
   * Has the user say how many pictures and where to, and saves them.
   *
   * @param over a control of the view's window
   * @param theme colours and fonts
   * @param title what users call the view
   * @param view of which pictures are taken
   */
  public void ask(Control over, Theme theme, String title, PictureSource view) {
    Optional<Timeline> timeline = live.timeline();
    Optional<TimeRange> range = timeline.map(Timeline::state).flatMap(PictureSaving::range);
    if (busy || range.isEmpty()) {
      MessageDialog.openInformation(over.getShell(), TITLE,
          busy ? "Pictures are being saved already." : "No recording is open.");
      return;
    }
    Optional<Double> rate = NameDialog.ask(over, TITLE, question(range.get()), RATE, w -> rate(w).isPresent())
        .flatMap(PictureSaving::rate);
    Optional<Path> file =
        rate.flatMap(r -> SaveDialog.ask(over, TITLE + " (.mp4, .webm: a video; .png: numbered files)",
            title.replaceAll("[^\\w-]+", "-") + ".mp4", "*.mp4", "*.webm", "*.png"));
    file.ifPresent(f -> save(over, theme, timeline.get(), new PictureSteps(range.get(), rate.get()), f, view));
  }

  private static Optional<TimeRange> range(TimelineState state) {
    return state.range().or(state::span);
  }

  private static String question(TimeRange range) {
    return String.format(Locale.ROOT,
        "Pictures for each second of the recording, 0.001 to 1000\n(of %.1f s: what lies between the grips of the strip)",
        range.length() / 1e9);
  }

  private static Optional<Double> rate(String words) {
    try {
      return Optional.of(Double.parseDouble(words.strip())).filter(r -> r >= SLOWEST && r <= FASTEST);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private void save(Control over, Theme theme, Timeline timeline, PictureSteps steps, Path file, PictureSource view) {
    AtomicBoolean cancelled = new AtomicBoolean();
    ProgressDialog progress = new ProgressDialog(over.getShell(), theme, TITLE, () -> cancelled.set(true));
    progress.open("0 of " + steps.count() + " pictures");
    busy = true;
    start(timeline, steps, file, view, cancelled, taken -> over.getDisplay().asyncExec(
        () -> progress.show(taken + " of " + steps.count() + " pictures")), answer -> {
          busy = false;
          progress.close();
          if (!over.isDisposed()) {
            MessageDialog.openInformation(over.getShell(), TITLE, words(answer, file));
          }
        });
  }

  private static String words(Answer<Integer> answer, Path file) {
    return switch (answer) {
      case Answer.Given<Integer> given -> given.value() + " pictures were written: " + file;
      case Answer.Failed<Integer> failed -> "It was not done to the end: " + failed.why();
    };
  }

  /** Without questions. */
  void start(Timeline timeline, PictureSteps steps, Path file, PictureSource view, AtomicBoolean cancelled,
      Consumer<Integer> progress, Consumer<Answer<Integer>> told) {
    calls.start(() -> {
      PictureTarget target = target(file, steps.rate());
      return new PictureSeries(timeline, view, cancelled::get).take(steps, target, progress::accept);
    }, told);
  }

  private PictureTarget target(Path file, double rate) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".png") ? new NumberedPictures(file)
        : new VideoOfPictures(videos.get().orElseThrow(
            () -> new IllegalArgumentException("the feature 'RobotUI recordings' is not installed")), file, rate);
  }
}
