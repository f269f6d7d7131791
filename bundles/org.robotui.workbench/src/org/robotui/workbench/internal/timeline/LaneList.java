package org.robotui.workbench.internal.timeline;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.api.replay.Track;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.SaveDialog;
import org.robotui.workbench.internal.timeline.LaneRows.Row;
import org.robotui.workbench.internal.timeline.RecordingCalls.Answer;

/** The recordings with their topics, above the strip and at its scale. Display thread only. */
final class LaneList {
  private static final int MOST_ROWS = 9;
  private static final int THUMB = 4;
  private static final int INSET = 26;
  private static final int MOST_OTHERS = 8;

  private final Theme theme;
  private final BarState bar;
  private final LiveTimeline live;
  private final Runnable changed;
  private final TrackAnalysis analysis;
  private final BiConsumer<Track, String> compare;
  private final PaintedCanvas canvas;
  private final LanePaint paint;
  private final TimeHands hands;
  private int top;
  private int focus;
  private Optional<Row> under = Optional.empty();

  /** A list of what a bar shows; {@code changed} is run when something is to be painted, or laid out, anew. */
  LaneList(Composite parent, Theme theme, BarState bar, LiveTimeline live, NewestSeek seek, Runnable changed,
      TrackAnalysis analysis, BiConsumer<Track, String> compare) {
    this.theme = theme;
    this.bar = bar;
    this.live = live;
    this.changed = changed;
    this.analysis = analysis;
    this.compare = compare;
    paint = new LanePaint(theme, bar, live, analysis);
    canvas = new PaintedCanvas(parent, SWT.NONE, theme, Role.PANEL, this::paint);
    // Before the hands: over more rows than are seen the wheel moves the rows.
    canvas.addListener(SWT.MouseVerticalWheel, this::wheel);
    hands = new TimeHands(canvas, bar, changed, seek, e -> false);
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseMove, e -> under = bar.rows().at(top + e.y));
    canvas.addListener(SWT.MouseEnter, e -> under = bar.rows().at(top + e.y));
    canvas.addListener(SWT.MouseExit, e -> under = Optional.empty());
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.MenuDetect, this::menu);
    canvas.addListener(SWT.FocusIn, e -> canvas.requestPaint());
    canvas.addListener(SWT.FocusOut, e -> canvas.requestPaint());
    TimeVoice.list(canvas, "Recordings", () -> bar.rows().row(focus).map(BarState::words).orElse(""));
  }

  PaintedCanvas canvas() {
    return canvas;
  }

  /** As high as its rows, where those are not many. */
  int height() {
    return Math.min(bar.rows().height(), MOST_ROWS * LaneRows.HEIGHT);
  }

  private void paint(GC gc, Rectangle area) {
    top = Math.clamp(top, 0, Math.max(0, bar.rows().height() - area.height));
    focus = Math.clamp(focus, 0, Math.max(0, bar.rows().rows().size() - 1));
    List<Row> rows = bar.rows().rows();
    TimeScale scale = bar.scale(area.width);
    for (int i = top / LaneRows.HEIGHT; i < rows.size() && i * LaneRows.HEIGHT < top + area.height; i++) {
      paint.paint(gc, rows.get(i), i * LaneRows.HEIGHT - top, area, canvas.isFocusControl() && i == focus);
    }
    TimePaint.line(gc, scale, scale.x(bar.state().position()), 0, area.height, theme.color(Role.TEXT), 1);
    bar.pointer().ifPresent(x -> pointer(gc, scale, x, area));
    bar.elsewhere(scale)
        .ifPresent(x -> TimePaint.line(gc, scale, x, 0, area.height, theme.color(Role.DIM), 1));
    if (bar.rows().height() > area.height) {
      int tall = Math.max(16, area.height * area.height / bar.rows().height());
      int y = (area.height - tall) * top / (bar.rows().height() - area.height);
      gc.setBackground(theme.color(Role.LINE));
      gc.fillRoundRectangle(area.width - THUMB - 2, y, THUMB, tall, THUMB, THUMB);
    }
  }

  private void pointer(GC gc, TimeScale scale, int x, Rectangle area) {
    TimePaint.line(gc, scale, x, 0, area.height, theme.color(Role.DIM), 1);
    if (under.isPresent() && under.get() instanceof Row.Topic topic) {
      int y = bar.rows().rows().indexOf(topic) * LaneRows.HEIGHT - top;
      long at = scale.time(x);
      String words =
          TimeWords.seconds(at - bar.all().start()) + "  " + StripPaint.counted(List.of(topic.of()), scale, at);
      TimePaint.hint(gc, theme, words, x, y + 2, new Rectangle(scale.left(), 0, scale.width(), area.height));
    }
  }

  private void wheel(Event event) {
    boolean more = bar.rows().height() > canvas.getSize().y;
    if ((event.stateMask & SWT.MOD1) == 0 && more) {
      top -= event.count * LaneRows.HEIGHT / 3;
      event.doit = false;
      changed.run();
    }
  }

  private void down(Event event) {
    Optional<Row> row = bar.rows().at(top + event.y);
    row.ifPresent(r -> focus = bar.rows().rows().indexOf(r));
    if (event.button == 1 && event.x < hands.scale().left() - BarGrip.REACH) {
      row.ifPresent(this::press);
    }
    canvas.requestPaint();
  }

  /** A recording is folded, a topic is the one to step by. */
  private void press(Row row) {
    switch (row) {
      case Row.Head head -> bar.fold(head.track().id().robot());
      case Row.Topic topic -> live.stepBy(topic.id());
    }
    changed.run();
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ARROW_UP -> focus(focus - 1);
      case SWT.ARROW_DOWN -> focus(focus + 1);
      case SWT.HOME -> focus(0);
      case SWT.END -> focus(bar.rows().rows().size() - 1);
      case SWT.CR, SWT.KEYPAD_CR -> bar.rows().row(focus).ifPresent(this::press);
      case ' ' -> live.timeline().map(TimelineMoves::new).ifPresent(TimelineMoves::toggle);
      default -> {}
    }
  }

  private void focus(int row) {
    focus = Math.clamp(row, 0, Math.max(0, bar.rows().rows().size() - 1));
    int y = focus * LaneRows.HEIGHT;
    top = Math.clamp(top, Math.max(0, y + LaneRows.HEIGHT - canvas.getSize().y), y);
    canvas.requestPaint();
  }

  private void menu(Event event) {
    boolean byKey = event.detail == SWT.MENU_KEYBOARD;
    int y = canvas.toControl(event.x, event.y).y;
    Optional<Row> row = byKey ? bar.rows().row(focus) : bar.rows().at(top + y);
    row.ifPresent(r -> menu(r, byKey ? canvas.toDisplay(INSET, focus * LaneRows.HEIGHT - top)
        : new Point(event.x, event.y)));
  }

  private void menu(Row row, Point at) {
    Track track = row.track();
    PopupMenu menu = new PopupMenu(canvas, changed);
    if (row instanceof Row.Topic topic) {
      menu.check("Step by the Messages of " + topic.of().lane().topic(),
          live.stepped().filter(topic.id()::equals).isPresent(), on -> live.stepBy(topic.id())).line();
    }
    if (row instanceof Row.Topic topic && live.tracks().size() > 1) {
      menu.push("Compare " + topic.of().lane().topic() + " with Another Recording\u2026",
          () -> compare.accept(track, topic.of().lane().topic())).line();
    }
    if (row instanceof Row.Topic topic && topic.of().lane().type().endsWith("Image")) {
      menu.push("Write a Video of " + topic.of().lane().topic() + "\u2026", !analysis.isBusy(track.id()),
          () -> video(track, topic.of().lane().topic())).line();
    }
    menu.push("Offset of " + track.file().getFileName() + " (" + TimeWords.offset(track.offset()) + " s)\u2026",
        () -> askOffset(track, "", track.offset()));
    live.tracks().stream().filter(other -> !other.id().equals(track.id())).limit(MOST_OTHERS)
        .forEach(other -> menu.push("Estimate Offset from " + other.id().robot() + ", "
            + other.file().getFileName() + "\u2026", !analysis.isBusy(track.id()), () -> estimate(other, track)));
    menu.push("Write a Report of " + track.file().getFileName() + "\u2026", !analysis.isBusy(track.id()),
        () -> report(track));
    menu.push("Begin with the Earliest Recording", track.span().start() > bar.all().start(),
        () -> live.timeline().ifPresent(t -> new TimelineMoves(t).align(track)));
    menu.push("Reset Offset", track.offset() != 0, () -> live.timeline().ifPresent(t -> t.shift(track.id(), 0)));
    menu.line().push("Show All of " + track.file().getFileName(), () -> bar.zoom(track.span()));
    track.problems().forEach(problem -> menu.line().push("\u26a0  " + problem, () -> Clipboards.copy(problem)));
    menu.open(at);
  }

  /** What was found is a proposal: the user sees what it was found by, and takes it, another one or none. */
  private void estimate(Track reference, Track moved) {
    analysis.offset(reference.id(), moved.id(), answer -> {
      if (!canvas.isDisposed()) {
        changed.run();
        switch (answer) {
          case Answer.Given<OffsetEstimate> given -> askOffset(moved, words(given.value()),
              rounded(given.value().offset()));
          case Answer.Failed<OffsetEstimate> failed -> askOffset(moved, failed.why() + ".", moved.offset());
        }
      }
    });
    changed.run();
  }

  private static String words(OffsetEstimate found) {
    return "Basis: " + found.basis() + "; deviation " + TimeWords.offset(rounded(found.deviation())) + "\u00a0s.";
  }

  private void report(Track track) {
    String name = track.file().getFileName().toString();
    SaveDialog.ask(canvas, "Write a Report", name.replaceFirst("\\.[^.]*$", "") + ".html", "*.html")
        .ifPresent(file -> {
          analysis.report(track.id(), file, answer -> told("Report of " + name, answer));
          changed.run();
        });
  }

  private void video(Track track, String topic) {
    SaveDialog.ask(canvas, "Write a Video", topic.replaceFirst("^/", "").replace('/', '_') + ".mp4", "*.mp4", "*.webm")
        .ifPresent(file -> {
          analysis.video(track.id(), topic, file, answer -> told("Video of " + topic, answer));
          changed.run();
        });
  }

  private void told(String title, Answer<Path> answer) {
    if (!canvas.isDisposed()) {
      changed.run();
      String words = switch (answer) {
        case Answer.Given<Path> given -> "It was written to " + given.value();
        case Answer.Failed<Path> failed -> "There is none: " + failed.why();
      };
      MessageDialog.openInformation(canvas.getShell(), title, words);
    }
  }

  /** To milliseconds: nobody can judge more. */
  private static long rounded(long nanos) {
    return Math.round(nanos * 1e-6) * 1_000_000;
  }

  private void askOffset(Track track, String found, long proposed) {
    String asked = (found + "\nSeconds added to the times of " + track.file().getFileName()).strip();
    NameDialog.ask(canvas, "Offset of " + track.file().getFileName(), asked, TimeWords.offset(proposed),
        words -> TimeWords.nanos(words).isPresent())
        .flatMap(TimeWords::nanos)
        .ifPresent(nanos -> live.timeline().ifPresent(t -> t.shift(track.id(), nanos)));
  }
}
