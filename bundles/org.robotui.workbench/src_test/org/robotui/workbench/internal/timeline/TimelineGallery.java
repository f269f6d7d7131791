package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.ComparisonWish;
import org.robotui.api.replay.ComparisonWish.Alignment;
import org.robotui.api.replay.ComparisonWish.Pairing;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.time.PointedTime;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.workbench.internal.display.Screenshot;

/**
 * A window with a bar, to look at without a workbench:
 * {@code TimelineGallery dark|light WIDTH FILE [expanded [find|compare]]}.
 */
final class TimelineGallery {
  private TimelineGallery() {}

  public static void main(String[] words) throws IOException {
    Display display = new Display();
    Theme theme = Themes.of(display, words[0]);
    Shell shell = new Shell(display, SWT.NO_TRIM);
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    shell.setLayout(layout);
    Composite views = new Composite(shell, SWT.NONE);
    views.setBackground(theme.color(Role.GROUND));
    views.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    PretendTimeline timeline = new PretendTimeline().filled();
    long begin = PretendTimeline.BEGIN;
    long second = PretendTimeline.SECOND;
    timeline.shift(PretendTimeline.HUSKY, second / 4);
    timeline.set(new TimelineState(timeline.state().span(), begin + 91_234_567_890L, words.length > 3, 0.05, true,
        Optional.of(new TimeRange(begin + 20 * second, begin + 250 * second)),
        List.of(new Bookmark(begin + 60 * second, "door"), new Bookmark(begin + 200 * second, "")), words.length > 3));
    LiveTimeline live = new LiveTimeline(Runnable::run);
    live.follow(Optional.of(timeline));
    PretendSearch service = new PretendSearch();
    service.events = List.of(PretendSearch.event(PretendTimeline.KEIRA, 12, 12, "battery.status is FULL, was CHARGING"),
        PretendSearch.event(PretendTimeline.HUSKY, 70, 71.5, "odom sent nothing for 3.0 s"),
        PretendSearch.event(PretendTimeline.KEIRA, 100, 140.25, "battery.charge is 0.1875"),
        PretendSearch.event(PretendTimeline.KEIRA, 230, 230.4, "the delay of base_scan is 0.213 s"));
    EventSearch search = new EventSearch(Runnable::run, Runnable::run, () -> Optional.of(service));
    RunCompare compare =
        new RunCompare(new RecordingCalls(Runnable::run, Runnable::run), () -> Optional.of(PretendComparison.CIRCLE));
    BarState bar = new BarState(new PointedTime());
    bar.expand(words.length > 3);
    live.stepBy(new LaneId(PretendTimeline.KEIRA, "/odom"));
    TimelineBar control = new TimelineBar(shell, theme, live, search, compare,
        new TrackAnalysis(new RecordingCalls(Runnable::run, Runnable::run), Optional::empty, Optional::empty,
            Optional::empty),
        bar);
    control.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, false));
    shell.setBounds(0, 0, Integer.parseInt(words[1]), 420);
    shell.open();
    if (words.length > 4 && words[4].equals("compare")) {
      control.compare().propose(timeline.tracks().getLast(), "/odom");
      compare
          .start(new ComparisonWish(PretendTimeline.KEIRA, PretendTimeline.HUSKY, "odom", Pairing.TIME, Alignment.SE3));
    } else if (words.length > 4) {
      search.start("battery charge < 0.2 for 5 s");
      control.find();
    }
    long end = System.nanoTime() + Duration.ofMillis(1500).toNanos();
    while (System.nanoTime() < end) {
      if (!display.readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
    Screenshot.save(shell, Path.of(words[2]));
    shell.dispose();
    theme.dispose();
    display.dispose();
  }
}
